#pragma once
// The best of a sequence of scored candidates; each of the equally good ones is kept with the same
// chance (reservoir sampling, Vitter 1985).
//
// Scores that differ by rounding only (relative 1e-9) are equal, so that a tie does not depend on
// the order of additions. O(1) and no allocation an offer; draws only at a tie.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/base/rng.h"

namespace ronda {

class RandomArgmax {
 public:
  explicit RandomArgmax(Rng& rng) : rng_(rng) {}

  void Offer(int candidate, double score) {
    constexpr double kTolerance = 1e-9;
    const double margin = kTolerance * std::max(std::abs(score), std::abs(best_score_));
    if (equals_ == 0 || score > best_score_ + margin) {
      best_ = candidate;
      best_score_ = score;
      equals_ = 1;
    } else if (score >= best_score_ - margin && rng_.Below(++equals_) == 0) {
      best_ = candidate;
    }
  }

  int best() const { return best_; }  // −1 before the first offer

 private:
  Rng& rng_;
  int best_ = -1;
  double best_score_ = 0.0;
  std::uint32_t equals_ = 0;
};

}  // namespace ronda
