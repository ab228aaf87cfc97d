#pragma once
// Conscientious Reactive (Machado et al. 2003; Portugal & Rocha 2013): the neighbour that has been
// idle for longest. A robot knows its own visits only; its start is the first of them. Ties at
// random.
#include "common/world/strategies/strategy.h"

namespace ronda {

class ConscientiousReactive final : public Strategy {
 public:
  Knowledge knowledge() const override { return {.visits = Knowledge::Visits::kOwn}; }
  int Decide(const Belief& belief, Rng& rng) override;
};

}  // namespace ronda
