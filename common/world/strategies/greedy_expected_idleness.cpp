#include "common/world/strategies/greedy_expected_idleness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/world/strategies/random_argmax.h"

namespace ronda {
namespace {

/// What the team announced about one vertex, without `robot`, which would be there at `at_s`.
struct Announced {
  bool another_heads_there = false;
  double last_visit_before_s = 0.0;  // real or announced, not after at_s
};

Announced AnnouncedAt(const PatrolWorld& world, int vertex, int robot, double at_s) {
  Announced announced{.last_visit_before_s = world.last_visit_s(vertex)};
  for (int other = 0; other < world.robot_count(); ++other) {
    if (other == robot || world.target(other) != vertex) continue;
    announced.another_heads_there = true;
    if (world.arrival_s(other) <= at_s) {
      announced.last_visit_before_s =
          std::max(announced.last_visit_before_s, world.arrival_s(other));
    }
  }
  return announced;
}

}  // namespace

int GreedyExpectedIdleness::Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) {
  constexpr double kSharedWeight = 0.05;
  const auto neighbours = world.graph().neighbours(arrival.vertex);
  const auto lengths_m = world.graph().lengths_m(arrival.vertex);
  RandomArgmax choice(rng);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const double at_s = arrival.time_s + world.travel_time_s(arrival.robot, lengths_m[k]);
    const Announced announced = AnnouncedAt(world, neighbours[k], arrival.robot, at_s);
    const double weight = announced.another_heads_there ? kSharedWeight : 1.0;
    choice.Offer(neighbours[k], weight * (at_s - announced.last_visit_before_s) /
                                    std::pow(lengths_m[k], length_exponent_));
  }
  return choice.best();
}

}  // namespace ronda
