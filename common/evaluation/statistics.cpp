#include "common/evaluation/statistics.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "common/base/check.h"

namespace ronda {
namespace {

double Mean(std::span<const double> values) {
  RONDA_CHECK(!values.empty(), "the mean of no values");
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

Estimate MeanWithInterval(std::span<const double> values) {
  const double mean = Mean(values);
  if (values.size() == 1) return {.mean = mean, .ci95 = std::nullopt};
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(values.size());
  const double standard_error = std::sqrt(squares / (count - 1.0) / count);
  const double quantile = boost::math::quantile(boost::math::students_t(count - 1.0), 0.975);
  return {.mean = mean, .ci95 = quantile * standard_error};
}

Estimate Over(const Estimate& estimate, double divisor) {
  Estimate quotient{.mean = estimate.mean / divisor, .ci95 = estimate.ci95};
  if (quotient.ci95) *quotient.ci95 /= divisor;
  return quotient;
}

Estimate PairedRatio(std::span<const double> numerators, std::span<const double> denominators) {
  RONDA_CHECK(numerators.size() == denominators.size(), "{} numerators, {} denominators",
              numerators.size(), denominators.size());
  const double mean_denominator = Mean(denominators);
  const double ratio = Mean(numerators) / mean_denominator;
  std::vector<double> linearised(numerators.size());
  for (std::size_t i = 0; i < numerators.size(); ++i) {
    linearised[i] = (numerators[i] - ratio * denominators[i]) / mean_denominator;
  }
  return {.mean = ratio, .ci95 = MeanWithInterval(linearised).ci95};
}

}  // namespace ronda
