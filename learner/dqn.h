#pragma once
// (Double) deep Q-learning: one gradient step for each mini-batch, against a target network.
//
// The loss is dqn_loss.h's; then the gradient's norm is clipped, Adam steps with a learning rate
// linear in progress, and the target network follows: a copy every `target_interval` updates, or
// θ' ← τ·θ + (1 − τ)·θ' at each. The defaults are the recipe for the per-candidate scorer with
// hindsight difference rewards. Errors and threads as algorithm.h; InputError from the constructor.
// Source: Mnih et al. 2015; van Hasselt, Guez & Silver 2016; Lillicrap et al. 2016 (soft target).
#include <cstdint>
#include <span>
#include <vector>

#include "common/nn/adam.h"
#include "learner/algorithm.h"
#include "learner/dqn_loss.h"

namespace ronda {

enum class TargetUpdate { kHard, kPolyak };

struct DqnConfig {
  NetworkSpec network{.kind = NetworkSpec::Kind::kCandidateScorer, .hidden = {64, 64}};
  DqnLossConfig loss = {};
  std::uint32_t batch_size = 128;     // what to ask the replay for; Update takes any
  double learning_rate_start = 1e-3;  // at progress 0
  double learning_rate_end = 1e-4;    // at progress 1
  double max_gradient_norm = 10.0;
  TargetUpdate target_update = TargetUpdate::kHard;
  std::uint64_t target_interval = 1000;  // updates, kHard
  double polyak = 0.005;                 // τ, kPolyak
  AdamConfig adam = {};
  std::uint64_t seed = 1;  // of the first weights
};

/// Throws InputError naming key, rule and value.
void CheckDqnConfig(const DqnConfig& config);

class Dqn final : public Algorithm {
 public:
  explicit Dqn(const DqnConfig& config);

  UpdateStats Update(const SampledBatch& batch) override;
  std::span<const float> parameters() const override { return online_; }
  std::uint64_t architecture_hash() const override { return loss_.network().architecture_hash(); }
  std::uint64_t updates() const override { return updates_; }
  void set_progress(double progress) override;
  AlgorithmState Save() const override;
  void Load(const AlgorithmState& state) override;

  const DqnConfig& config() const { return config_; }
  std::span<const float> target_parameters() const { return target_; }
  double learning_rate() const;  // of the next update

 private:
  void UpdateTarget();

  DqnConfig config_;
  DqnLoss<float> loss_;
  std::vector<float> online_, target_, gradient_;  // (P)
  Adam<float> adam_;
  std::uint64_t updates_ = 0;
  double progress_ = 0.0;
};

}  // namespace ronda
