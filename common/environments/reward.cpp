#include "common/environments/reward.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "common/base/error.h"

namespace ronda {

std::vector<std::string> RewardSchemeNames() { return {"idleness", "hindsight"}; }

RewardScheme ParseRewardScheme(const std::string& name) {
  if (name == "idleness") return RewardScheme::kIdleness;
  if (name == "hindsight") return RewardScheme::kHindsight;
  throw InputError(fmt::format("no reward is called '{}'; there are {}", name,
                               fmt::join(RewardSchemeNames(), ", ")));
}

float IdlenessReward(const Visit& visit) {
  return static_cast<float>(std::exp(-visit.travel_s / visit.horizon_s) * visit.idleness_s * 2.0 /
                            visit.reference_s);
}

float HindsightReward(const Visit& visit, double until_next_visit_s) {
  const double gone = -std::expm1(-until_next_visit_s / visit.horizon_s);  // 1 − γ^Δ
  return static_cast<float>(IdlenessReward(visit) * gone);
}

}  // namespace ronda
