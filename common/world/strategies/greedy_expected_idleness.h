#pragma once
// Greedy on expected idleness, GEI(p): the neighbour with the greatest w·Î / c^p. Of no paper; the
// project's yardstick for what a robot can do that looks one edge ahead.
//
// Î is the idleness that the neighbour will have when this robot arrives, given the announced
// arrivals before; c is the edge's length; w is 0.05 if another robot heads there, else 1. A robot
// knows everyone's visits and announced arrivals. Ties at random.
#include "common/world/strategies/strategy.h"

namespace ronda {

class GreedyExpectedIdleness final : public Strategy {
 public:
  /// `length_exponent` is p ≥ 0.
  explicit GreedyExpectedIdleness(double length_exponent) : length_exponent_(length_exponent) {}

  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .intentions = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;

 private:
  double length_exponent_;
};

}  // namespace ronda
