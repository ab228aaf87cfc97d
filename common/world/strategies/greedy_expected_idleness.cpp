#include "common/world/strategies/greedy_expected_idleness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/world/strategies/random_argmax.h"

namespace ronda {
namespace {

/// What the team announced about one vertex, where this robot would be at `at_s`.
struct Announced {
  bool another_heads_there = false;
  double last_visit_before_s = 0.0;  // real or announced, not after at_s
};

Announced AnnouncedAt(const Belief& belief, int vertex, double at_s) {
  Announced announced{.last_visit_before_s = belief.last_visit_s(vertex)};
  for (int other = 0; other < belief.robot_count(); ++other) {
    if (other == belief.robot || belief.target(other) != vertex) continue;
    announced.another_heads_there = true;
    if (belief.arrival_s(other) <= at_s) {
      announced.last_visit_before_s =
          std::max(announced.last_visit_before_s, belief.arrival_s(other));
    }
  }
  return announced;
}

}  // namespace

int GreedyExpectedIdleness::Decide(const Belief& belief, Rng& rng) {
  constexpr double kSharedWeight = 0.05;
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  const auto lengths_m = belief.graph->lengths_m(belief.vertex);
  RandomArgmax choice(rng);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const double at_s = belief.time_s + belief.travel_time_s(lengths_m[k]);
    const Announced announced = AnnouncedAt(belief, neighbours[k], at_s);
    const double weight = (announced.another_heads_there ? kSharedWeight : 1.0) *
                          belief.graph->weights()[neighbours[k]];
    choice.Offer(neighbours[k], weight * std::max(0.0, at_s - announced.last_visit_before_s) /
                                    std::pow(lengths_m[k], length_exponent_));
  }
  return choice.best();
}

}  // namespace ronda
