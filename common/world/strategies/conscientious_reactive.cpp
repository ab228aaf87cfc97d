#include "common/world/strategies/conscientious_reactive.h"

#include "common/world/strategies/random_argmax.h"

namespace ronda {

int ConscientiousReactive::Decide(const Belief& belief, Rng& rng) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  FindCandidates(belief, sharing_, candidates_);
  RandomArgmax choice(rng);
  for (const int k : candidates_) choice.Offer(neighbours[k], belief.idleness_s(neighbours[k]));
  return choice.best();
}

}  // namespace ronda
