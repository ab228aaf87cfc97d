#include "common/world/strategies/hcr.h"

#include <algorithm>

#include "common/world/strategies/random_argmax.h"
#include "common/world/strategies/share_of.h"

namespace ronda {

int HeuristicReactive::Decide(const Belief& belief, Rng& rng) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  const auto lengths_m = belief.graph->lengths_m(belief.vertex);
  FindCandidates(belief, sharing_, candidates_);
  double longest_m = 0.0;
  double most_idle_s = 0.0;
  for (const int k : candidates_) {
    longest_m = std::max(longest_m, lengths_m[k]);
    most_idle_s = std::max(most_idle_s, belief.idleness_s(neighbours[k]));
  }
  RandomArgmax choice(rng);
  for (const int k : candidates_) {
    choice.Offer(neighbours[k], ShareOf(longest_m - lengths_m[k], longest_m) +
                                    ShareOf(belief.idleness_s(neighbours[k]), most_idle_s));
  }
  return choice.best();
}

}  // namespace ronda
