#pragma once
// The loss of (Double) deep Q-learning on one mini-batch, and its gradient.
//
//   y = r + discount · Q_target(s', argmax_a Q_online(s', a))     (Double; else max_a Q_target(s',
//   a)) L = mean over the batch of w · loss(Q_online(s, a) − y)       (w: importance weights; y is
//   fixed)
//
// Ties of the argmax go to the lowest action; illegal actions are out. Where discount = 0, nothing
// of s' is read. The target network runs on the chosen action alone. Errors: InputError for a batch
// that does not fit the network (sizes, an action out of range, no legal next action where the
// discount is not 0). Thread-compatible; allocates nothing once it has grown. Float and double.
// Source: Mnih et al. 2015; van Hasselt, Guez & Silver 2016; thesis §2.4.
#include <cstdint>
#include <span>
#include <vector>

#include "common/nn/losses.h"
#include "common/nn/q_network.h"
#include "common/rl/messages.h"

namespace ronda {

struct DqnLossConfig {
  bool double_q = true;
  LossKind loss = LossKind::kHuber;
  double huber_delta = 2.0;
};

template <typename Scalar>
class DqnLoss {
 public:
  struct Result {
    double loss = 0.0;
    double mean_absolute_td = 0.0;
    double mean_q = 0.0;
  };

  DqnLoss(const NetworkSpec& spec, const DqnLossConfig& config);

  const QNetwork<Scalar>& network() const { return network_; }

  /// Overwrites `gradient` (P) with ∂L/∂online.
  Result Evaluate(std::span<const Scalar> online, std::span<const Scalar> target,
                  const SampledBatch& batch, std::span<Scalar> gradient);

  std::span<const Scalar> targets() const { return targets_; }  // (B) y of the last call
  std::span<const float> absolute_td() const {
    return absolute_td_;
  }  // (B) |y − Q| of the last call

 private:
  void CheckBatch(const SampledBatch& batch) const;
  void ComputeTargets(std::span<const Scalar> online, std::span<const Scalar> target,
                      const SampledBatch& batch);

  DqnLossConfig config_;
  QNetwork<Scalar> network_;
  typename QNetwork<Scalar>::Workspace workspace_;
  std::vector<Scalar> observations_, next_observations_;  // (B, O) converted, for double only
  std::vector<std::uint8_t> next_legal_;                  // (B, A) all 0 where discount = 0
  std::vector<Scalar> next_q_;                            // (B, A)
  std::vector<std::int32_t> next_actions_;                // (B)
  std::vector<Scalar> next_values_;                       // (B)
  std::vector<Scalar> targets_;                           // (B)
  std::vector<Scalar> q_;                                 // (B)
  std::vector<Scalar> slopes_;                            // (B) ∂L/∂q
  std::vector<float> absolute_td_;                        // (B)
};

extern template class DqnLoss<float>;
extern template class DqnLoss<double>;

}  // namespace ronda
