#pragma once
// Acts greedily on a Q network. Contract as rl/policy.h; Act allocates nothing once warm.
#include <cstdint>
#include <span>
#include <vector>

#include "common/nn/q_network.h"
#include "common/rl/policy.h"

namespace ronda {

class QPolicy final : public Policy {
 public:
  /// With weights that are all 0 until Load. InputError as CheckNetworkSpec.
  explicit QPolicy(const NetworkSpec& spec);

  int Act(std::span<const float> observation, std::span<const std::uint8_t> legal_actions) override;
  [[nodiscard]] LoadResult Load(const WeightSnapshot& snapshot) override;
  std::uint64_t architecture_hash() const override { return network_.architecture_hash(); }

  /// (A) of one observation, −∞ where illegal; valid until the next call.
  std::span<const float> QValues(std::span<const float> observation,
                                 std::span<const std::uint8_t> legal_actions);
  const NetworkSpec& spec() const { return network_.spec(); }
  std::uint64_t weights_version() const { return weights_version_; }  // of the last snapshot loaded

 private:
  QNetwork<float> network_;
  QNetwork<float>::Workspace workspace_;
  std::vector<float> weights_;   // (P)
  std::vector<float> q_values_;  // (A)
  std::uint64_t weights_version_ = 0;
};

}  // namespace ronda
