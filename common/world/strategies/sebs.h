#pragma once
// State Exchange Bayesian Strategy, SEBS (Portugal & Rocha 2013): the neighbour with the greatest
// Bayesian gain, less for each teammate that heads there.
//
// The gain of GBS (gbs.h) times 2^(R−k)/(2^R − 1) when k > 0 of R robots head to that vertex. A
// robot knows everyone's visits and targets. Ties at random.
#include "common/world/strategies/strategy.h"

namespace ronda {

class StateExchangeBayesian final : public Strategy {
 public:
  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .intentions = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;
};

/// The factor of SEBS when `heading` of `robots` robots head to the vertex.
double StateExchangeFactor(int heading, int robots);

}  // namespace ronda
