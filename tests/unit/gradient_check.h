#pragma once
// Central differences in double: how far a gradient is from (f(θ + h) − f(θ − h)) / 2h.
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "common/base/rng.h"

namespace ronda::testing {

/// The largest |difference| / max(1, |gradient|) over all entries. `loss` reads `values`, which are
/// put back. Truncation and rounding leave about 1e-9 for losses of order 1; kinks must not lie
/// within h.
template <typename Loss>
double LargestGradientError(Loss loss, std::span<double> values, std::span<const double> gradient) {
  constexpr double kStep = 1e-5;
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double kept = values[i];
    values[i] = kept + kStep;
    const double above = loss();
    values[i] = kept - kStep;
    const double below = loss();
    values[i] = kept;
    const double error = std::abs((above - below) / (2.0 * kStep) - gradient[i]);
    largest = std::max(largest, error / std::max(1.0, std::abs(gradient[i])));
  }
  return largest;
}

template <typename Scalar = double>
std::vector<Scalar> RandomVector(Rng& rng, std::size_t size, double scale = 1.0) {
  std::vector<Scalar> values(size);
  for (Scalar& value : values) value = static_cast<Scalar>(scale * rng.Normal());
  return values;
}

}  // namespace ronda::testing
