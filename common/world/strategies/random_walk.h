#pragma once
// Random walk: a uniformly random neighbour. Its robots know nothing. The yardstick of the thesis
// (§4.3).
#include "common/world/strategies/strategy.h"

namespace ronda {

class RandomWalk final : public Strategy {
 public:
  int Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) override;
};

}  // namespace ronda
