#include "common/environments/idleness_scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr float kLargest = 8.0f;

}  // namespace

double AlphaTransform(double x, double alpha) {
  const double rate = std::log(alpha);
  return std::expm1(x * rate) / std::expm1(rate);
}

ScaledIdleness::ScaledIdleness(IdlenessScale scale, double alpha, int vertices)
    : scale_(scale),
      alpha_(alpha),
      idleness_s_(static_cast<std::size_t>(vertices)),
      scaled_(idleness_s_.size()) {
  const bool is_share = scale == IdlenessScale::kRanking || scale == IdlenessScale::kNormalised;
  RONDA_CHECK(alpha == 0.0 || (is_share && alpha > 1.0), "α = {} for scale {}", alpha,
              static_cast<int>(scale));
  if (scale == IdlenessScale::kRanking) order_.resize(scaled_.size());
}

void ScaledIdleness::Rank() {
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) {
    return idleness_s_[a] != idleness_s_[b] ? idleness_s_[a] < idleness_s_[b] : a < b;
  });
  for (std::size_t k = 0; k < order_.size(); ++k) {
    scaled_[order_[k]] = static_cast<float>(k + 1) / static_cast<float>(order_.size());
  }
}

void ScaledIdleness::Normalise() {
  const auto [least, most] = std::minmax_element(idleness_s_.begin(), idleness_s_.end());
  const double least_s = *least;
  const double range_s = *most - least_s;  // ζmax − ζmin
  std::transform(idleness_s_.begin(), idleness_s_.end(), scaled_.begin(), [&](double idleness_s) {
    return range_s > 0.0 ? static_cast<float>((idleness_s - least_s) / range_s) : 0.0f;
  });
}

std::span<const float> ScaledIdleness::Observe(const Belief& belief, double floor_s) {
  for (std::size_t v = 0; v < idleness_s_.size(); ++v) {
    idleness_s_[v] = belief.idleness_s(static_cast<int>(v));
  }
  const double sum_s = std::accumulate(idleness_s_.begin(), idleness_s_.end(), 0.0);
  const double mean_s = std::max(floor_s, sum_s / static_cast<double>(idleness_s_.size()));
  const auto scale = [&](auto value_of_ratio) {
    std::transform(idleness_s_.begin(), idleness_s_.end(), scaled_.begin(), [&](double idleness_s) {
      return std::min(kLargest, static_cast<float>(value_of_ratio(idleness_s / mean_s)));
    });
  };
  switch (scale_) {
    case IdlenessScale::kRelative:
      scale([](double ratio) { return std::log1p(ratio); });
      break;
    case IdlenessScale::kRanking:
      Rank();
      break;
    case IdlenessScale::kNormalised:
      Normalise();
      break;
    case IdlenessScale::kCentred:
      scale([](double ratio) { return ratio - 1.0; });
      break;
  }
  if (alpha_ > 1.0) {
    for (float& value : scaled_) value = static_cast<float>(AlphaTransform(value, alpha_));
  }
  return scaled_;
}

}  // namespace ronda
