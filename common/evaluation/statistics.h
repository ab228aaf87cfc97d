#pragma once
// Means over episodes with 95 % intervals (Student 1908).
//
// Pure functions. Sizes that do not fit are bugs.
#include <optional>
#include <span>

namespace ronda {

/// A mean and the half width of its 95 % interval; none where one value says nothing of the spread.
struct Estimate {
  double mean = 0.0;
  std::optional<double> ci95;
};

/// Of independent values, at least one.
Estimate MeanWithInterval(std::span<const double> values);

/// The estimate of a value divided by what is known exactly.
Estimate Over(const Estimate& estimate, double divisor);

/// Mean numerator over mean denominator, of values paired by episode; the interval is that of the
/// linearised ratio (Cochran 1977, §6.4), so what the pairs share cancels.
Estimate PairedRatio(std::span<const double> numerators, std::span<const double> denominators);

}  // namespace ronda
