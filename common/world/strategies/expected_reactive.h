#pragma once
// Expected Reactive, ER (Yan & Zhang 2016): the neighbour with the largest expected idleness per
// second of travel, |t + d − t_exp| / d.
//
// d is the travel time, t_exp the earliest announced arrival of another robot there, else the last
// visit. A robot knows everyone's visits and announced arrivals. Ties at random.
#include "common/world/strategies/strategy.h"

namespace ronda {

class ExpectedReactive final : public Strategy {
 public:
  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .intentions = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;
};

}  // namespace ronda
