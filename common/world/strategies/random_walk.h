#pragma once
// Random walk: a uniformly random neighbour. Its robots know nothing. The yardstick of the thesis
// (§4.3).
#include "common/world/strategies/strategy.h"

namespace ronda {

class RandomWalk final : public Strategy {
 public:
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& belief, Rng& rng) override;
};

}  // namespace ronda
