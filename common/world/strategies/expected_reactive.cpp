#include "common/world/strategies/expected_reactive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "common/world/strategies/random_argmax.h"

namespace ronda {
namespace {

constexpr double kNever_s = std::numeric_limits<double>::infinity();

double EarliestAnnouncedArrival_s(const PatrolWorld& world, int vertex, int robot) {
  double earliest_s = kNever_s;
  for (int other = 0; other < world.robot_count(); ++other) {
    if (other != robot && world.target(other) == vertex) {
      earliest_s = std::min(earliest_s, world.arrival_s(other));
    }
  }
  return earliest_s;
}

}  // namespace

int ExpectedReactive::Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) {
  const auto neighbours = world.graph().neighbours(arrival.vertex);
  const auto lengths_m = world.graph().lengths_m(arrival.vertex);
  RandomArgmax choice(rng);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const double travel_s = world.travel_time_s(arrival.robot, lengths_m[k]);
    const double announced_s = EarliestAnnouncedArrival_s(world, neighbours[k], arrival.robot);
    const double expected_s =
        announced_s < kNever_s ? announced_s : world.last_visit_s(neighbours[k]);
    choice.Offer(neighbours[k], std::abs(arrival.time_s + travel_s - expected_s) / travel_s);
  }
  return choice.best();
}

}  // namespace ronda
