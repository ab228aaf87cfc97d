#pragma once
// State Exchange Bayesian Strategy, SEBS (Portugal & Rocha 2013): the neighbour with the greatest
// Bayesian gain, less for each teammate that heads there.
//
// Gain G = I / max(c, e_min), I the idleness in seconds at 1 m/s (idleness times the robot's
// speed), c the edge's length in the map's px; P = L·exp(ln(1/L)/M · G), and 1 from G = M on (the
// Greedy Bayesian Strategy, GBS); times 2^(R−k)/(2^R − 1) when k > 0 of R robots head to that
// vertex. L = 0.1, M = 100, e_min = 1 px. A robot knows everyone's visits and targets. Ties at
// random.
#include "common/world/strategies/strategy.h"

namespace ronda {

class StateExchangeBayesian final : public Strategy {
 public:
  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .intentions = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;
};

/// P of GBS for one neighbour.
double BayesianGainProbability(double idleness_s, double length_px);

/// The factor of SEBS when `heading` of `robots` robots head to the vertex.
double StateExchangeFactor(int heading, int robots);

}  // namespace ronda
