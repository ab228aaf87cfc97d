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
    : scale_(scale), alpha_(alpha), scaled_(static_cast<std::size_t>(vertices)) {
  const bool is_share = scale == IdlenessScale::kRanking || scale == IdlenessScale::kNormalised;
  RONDA_CHECK(alpha == 0.0 || (is_share && alpha > 1.0), "α = {} for scale {}", alpha,
              static_cast<int>(scale));
  if (scale == IdlenessScale::kRanking) order_.resize(scaled_.size());
}

void ScaledIdleness::Rank(const PatrolWorld& world) {
  const auto last_visits_s = world.last_visits_s();
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) {
    return last_visits_s[a] != last_visits_s[b] ? last_visits_s[a] > last_visits_s[b] : a < b;
  });
  for (std::size_t k = 0; k < order_.size(); ++k) {
    scaled_[order_[k]] = static_cast<float>(k + 1) / static_cast<float>(order_.size());
  }
}

void ScaledIdleness::Normalise(const PatrolWorld& world) {
  const auto last_visits_s = world.last_visits_s();
  const auto [most, least] = std::minmax_element(last_visits_s.begin(), last_visits_s.end());
  const double range_s = *least - *most;  // ζmax − ζmin
  for (std::size_t v = 0; v < scaled_.size(); ++v) {
    scaled_[v] = range_s > 0.0 ? static_cast<float>((*least - last_visits_s[v]) / range_s) : 0.0f;
  }
}

std::span<const float> ScaledIdleness::Observe(const PatrolWorld& world, double floor_s) {
  const double mean_s = std::max(floor_s, world.instantaneous_graph_idleness_s());
  switch (scale_) {
    case IdlenessScale::kRelative:
      for (std::size_t v = 0; v < scaled_.size(); ++v) {
        const double ratio = world.idleness_s(static_cast<int>(v)) / mean_s;
        scaled_[v] = std::min(kLargest, static_cast<float>(std::log1p(ratio)));
      }
      break;
    case IdlenessScale::kRanking:
      Rank(world);
      break;
    case IdlenessScale::kNormalised:
      Normalise(world);
      break;
    case IdlenessScale::kCentred:
      for (std::size_t v = 0; v < scaled_.size(); ++v) {
        const double above_s = world.idleness_s(static_cast<int>(v)) - mean_s;
        scaled_[v] = std::min(kLargest, static_cast<float>(above_s / mean_s));
      }
      break;
  }
  if (alpha_ > 1.0) {
    for (float& value : scaled_) value = static_cast<float>(AlphaTransform(value, alpha_));
  }
  return scaled_;
}

}  // namespace ronda
