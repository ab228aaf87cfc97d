#pragma once
// Greedy Bayesian Strategy, GBS (Portugal & Rocha 2013): the neighbour with the greatest gain.
//
// Gain G_j = I_j / max(c_j, e_min), I the idleness in seconds at 1 m/s (idleness times the robot's
// speed), c the edge's length in the map's px; P_j = L·exp(ln(1/L)/M · G_j), and 1 from G_j = M on.
// L = 0.1, M = 100, e_min = 1 px. A robot knows everyone's visits; the variant `gbs:claims` also
// where the others head (sharing.h). Ties at random, so beyond M all neighbours are alike.
#include <vector>

#include "common/world/strategies/sharing.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

/// P for the neighbour at place `k` of where the robot stands.
double BayesianGain(const Belief& belief, std::size_t k);

/// P of one idleness and length.
double BayesianGainProbability(double idleness_s, double length_px);

class GreedyBayesian final : public Strategy {
 public:
  explicit GreedyBayesian(Sharing sharing) : sharing_(sharing) {}

  Knowledge knowledge() const override { return KnowledgeOf(sharing_); }
  int Decide(const Belief& belief, Rng& rng) override;

 private:
  Sharing sharing_;
  std::vector<int> candidates_;  // scratch
};

}  // namespace ronda
