#pragma once
// Which transitions a mini-batch holds: uniform, or proportional to priority (Schaul et al. 2016,
// eq. 1 and §3.4).
//
// Prioritised: P(i) = p_i^α / Σ p^α, importance weight (1 / (n·P(i)))^β divided by the batch's
// largest. A new transition gets the largest priority seen; priorities that come back are |TD
// error| + ε. With α = 0 it is uniform. With replacement. O(log capacity) a draw.
// Thread-compatible; all randomness from the Rng passed in.
#include <cstdint>
#include <optional>

#include "common/base/rng.h"
#include "common/rl/messages.h"
#include "replay/replay_buffer.h"
#include "replay/sum_tree.h"

namespace ronda {

struct SamplerConfig {
  bool prioritised = false;
  double alpha = 0.6;            // ≥ 0
  double beta = 0.4;             // 0 … 1
  double priority_floor = 1e-3;  // ε > 0, so that nothing is never drawn
};

class Sampler {
 public:
  Sampler(const SamplerConfig& config, std::uint64_t capacity);

  void Inserted(const ReplayBuffer& buffer, std::uint64_t key);
  /// Priorities of keys that are no longer live, or that are not finite and ≥ 0, are ignored.
  void Update(const ReplayBuffer& buffer, const PriorityUpdate& update);
  /// Fills `batch` (its arrays, keys and importance weights) with `count` draws from a buffer that
  /// is not empty.
  void Sample(const ReplayBuffer& buffer, std::uint32_t count, Rng& rng, SampledBatch& batch) const;

 private:
  SamplerConfig config_;
  double largest_ = 1.0;         // p^α
  std::optional<SumTree> tree_;  // p^α by slot; only where prioritised
};

}  // namespace ronda
