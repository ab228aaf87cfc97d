#include "common/world/strategies/conscientious_reactive.h"

#include "common/world/strategies/random_argmax.h"

namespace ronda {

int ConscientiousReactive::Decide(const Belief& belief, Rng& rng) {
  RandomArgmax choice(rng);
  for (const int neighbour : belief.graph->neighbours(belief.vertex)) {
    choice.Offer(neighbour, belief.idleness_s(neighbour));
  }
  return choice.best();
}

}  // namespace ronda
