#include "common/world/strategies/sebs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/world/strategies/random_argmax.h"

namespace ronda {

double BayesianGainProbability(double idleness_s, double length_px) {
  constexpr double kLowest = 0.1;           // L
  constexpr double kSaturation = 100.0;     // M
  constexpr double kShortestEdge_px = 1.0;  // e_min
  const double gain = idleness_s / std::max(length_px, kShortestEdge_px);
  if (gain >= kSaturation) return 1.0;
  return kLowest * std::exp(-std::log(kLowest) / kSaturation * gain);
}

double StateExchangeFactor(int heading, int robots) {
  if (heading == 0) return 1.0;
  // 2^(R−k)/(2^R − 1), written so that a large team does not overflow.
  return std::exp2(-heading) / (1.0 - std::exp2(-robots));
}

int StateExchangeBayesian::Decide(const Belief& belief, Rng& rng) {
  const PatrolGraph& graph = *belief.graph;
  const auto neighbours = graph.neighbours(belief.vertex);
  const auto lengths_m = graph.lengths_m(belief.vertex);
  RandomArgmax choice(rng);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const double idleness_s =
        belief.idleness_s(neighbours[k]) * belief.speeds_mps[belief.robot];  // at 1 m/s
    choice.Offer(neighbours[k],
                 BayesianGainProbability(idleness_s, lengths_m[k] / graph.metres_per_px()) *
                     StateExchangeFactor(belief.claims(neighbours[k]), belief.robot_count()));
  }
  return choice.best();
}

}  // namespace ronda
