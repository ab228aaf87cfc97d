#include "common/world/strategies/expected_reactive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/world/strategies/random_argmax.h"

namespace ronda {
namespace {

double EarliestAnnouncedArrival_s(const Belief& belief, int vertex) {
  double earliest_s = kNever_s;
  for (int other = 0; other < belief.robot_count(); ++other) {
    if (other != belief.robot && belief.target(other) == vertex) {
      earliest_s = std::min(earliest_s, belief.arrival_s(other));
    }
  }
  return earliest_s;
}

}  // namespace

int ExpectedReactive::Decide(const Belief& belief, Rng& rng) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  const auto lengths_m = belief.graph->lengths_m(belief.vertex);
  RandomArgmax choice(rng);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const double travel_s = belief.travel_time_s(lengths_m[k]);
    const double announced_s = EarliestAnnouncedArrival_s(belief, neighbours[k]);
    const double expected_s =
        announced_s < kNever_s ? announced_s : belief.last_visit_s(neighbours[k]);
    choice.Offer(neighbours[k], belief.graph->weights()[neighbours[k]] *
                                    std::abs(belief.time_s + travel_s - expected_s) / travel_s);
  }
  return choice.best();
}

}  // namespace ronda
