#include "common/environments/reward.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/error.h"

namespace ronda {

RewardScheme ParseRewardScheme(const std::string& name) {
  for (const auto scheme : {RewardScheme::kIdleness, RewardScheme::kHindsight}) {
    if (name == Name(scheme)) return scheme;
  }
  throw UsageError(fmt::format("the reward must be one of idleness, hindsight, got '{}'", name));
}

std::string_view Name(RewardScheme scheme) {
  return scheme == RewardScheme::kIdleness ? "idleness" : "hindsight";
}

float Discount(double duration_s, double horizon_s) {
  return std::max(std::numeric_limits<float>::min(),
                  static_cast<float>(std::exp(-duration_s / horizon_s)));
}

float IdlenessReward(const Visit& visit, const RewardScale& scale) {
  return static_cast<float>(std::exp(-visit.travel_s / scale.horizon_s) * visit.idleness_s * 2.0 /
                            scale.reference_s);
}

float HindsightReward(const Visit& visit, double next_visit_after_s, const RewardScale& scale) {
  // 1 − γ^Δ without cancellation for a small Δ.
  const double not_collected = -std::expm1(-next_visit_after_s / scale.horizon_s);
  return static_cast<float>(IdlenessReward(visit, scale) * not_collected);
}

}  // namespace ronda
