#include "common/world/strategies/sebs.h"

#include <cmath>
#include <cstddef>

#include "common/world/strategies/gbs.h"
#include "common/world/strategies/random_argmax.h"

namespace ronda {

double StateExchangeFactor(int heading, int robots) {
  if (heading == 0) return 1.0;
  // 2^(R−k)/(2^R − 1), written so that a large team does not overflow.
  return std::exp2(-heading) / (1.0 - std::exp2(-robots));
}

int StateExchangeBayesian::Decide(const Belief& belief, Rng& rng) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  RandomArgmax choice(rng);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    choice.Offer(neighbours[k],
                 BayesianGain(belief, k) *
                     StateExchangeFactor(belief.claims(neighbours[k]), belief.robot_count()));
  }
  return choice.best();
}

}  // namespace ronda
