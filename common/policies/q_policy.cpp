#include "common/policies/q_policy.h"

#include <algorithm>
#include <cmath>

#include "common/base/check.h"

namespace ronda {

QPolicy::QPolicy(const NetworkSpec& spec)
    : network_(spec),
      weights_(network_.parameter_count()),
      q_values_(static_cast<std::size_t>(spec.num_actions)) {}

std::span<const float> QPolicy::QValues(std::span<const float> observation,
                                        std::span<const std::uint8_t> legal_actions) {
  network_.Forward(weights_, observation, legal_actions, workspace_, q_values_);
  return q_values_;
}

int QPolicy::Act(std::span<const float> observation, std::span<const std::uint8_t> legal_actions) {
  const std::span<const float> q = QValues(observation, legal_actions);
  int best = -1;
  for (std::size_t a = 0; a < q.size(); ++a)
    if (legal_actions[a] != 0 && (best < 0 || q[a] > q[static_cast<std::size_t>(best)]))
      best = static_cast<int>(a);
  RONDA_CHECK(best >= 0, "none of {} actions is legal", q.size());
  return best;
}

LoadResult QPolicy::Load(const WeightSnapshot& snapshot) {
  if (snapshot.architecture_hash != architecture_hash() ||
      snapshot.values.size() != weights_.size())
    return LoadResult::kOtherArchitecture;
  const auto finite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(snapshot.values.begin(), snapshot.values.end(), finite))
    return LoadResult::kNotFinite;
  std::copy(snapshot.values.begin(), snapshot.values.end(), weights_.begin());
  weights_version_ = snapshot.version;
  return LoadResult::kLoaded;
}

}  // namespace ronda
