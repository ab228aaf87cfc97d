#include "common/world/strategies/gbs.h"

#include <algorithm>
#include <cmath>

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

double BayesianGain(const Belief& belief, std::size_t k) {
  const PatrolGraph& graph = *belief.graph;
  const double idleness_s = belief.idleness_s(graph.neighbours(belief.vertex)[k]) *
                            belief.speeds_mps[belief.robot];  // at 1 m/s
  return BayesianGainProbability(idleness_s,
                                 graph.lengths_m(belief.vertex)[k] / graph.metres_per_px());
}

int GreedyBayesian::Decide(const Belief& belief, Rng& rng) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  FindCandidates(belief, sharing_, candidates_);
  RandomArgmax choice(rng);
  for (const int k : candidates_) choice.Offer(neighbours[k], BayesianGain(belief, k));
  return choice.best();
}

}  // namespace ronda
