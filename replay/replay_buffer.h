#pragma once
// A bounded store of transitions, the oldest overwritten first. Flat row-major arrays, allocated
// once.
//
// Every transition gets a key, counted from 0 in order of insertion; a key is live until `capacity`
// newer ones have come. Memory: BytesPerTransition(shape) · capacity. Thread-compatible.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/rl/messages.h"
#include "common/rl/transition.h"

namespace ronda {

class ReplayBuffer {
 public:
  ReplayBuffer(const TransitionShape& shape, std::size_t capacity);

  static std::size_t BytesPerTransition(const TransitionShape& shape);

  /// Copies row `row` of a batch of the same shape; returns its key.
  std::uint64_t Insert(const TransitionBatch& batch, std::size_t row);
  /// Appends the transition of a live key to the arrays of `to` (not its key or importance weight).
  void AppendTo(SampledBatch& to, std::uint64_t key) const;

  bool IsLive(std::uint64_t key) const { return key < next_key_ && next_key_ - key <= capacity_; }
  std::size_t SlotOf(std::uint64_t key) const { return static_cast<std::size_t>(key % capacity_); }
  std::uint64_t oldest_key() const { return next_key_ - size(); }
  std::uint64_t size() const { return next_key_ < capacity_ ? next_key_ : capacity_; }
  std::uint64_t capacity() const { return capacity_; }
  const TransitionShape& shape() const { return shape_; }

 private:
  TransitionShape shape_;
  std::uint64_t capacity_;  // C
  std::uint64_t next_key_ = 0;
  std::vector<float> observations_;               // (C, O)
  std::vector<float> next_observations_;          // (C, O)
  std::vector<std::uint8_t> next_legal_actions_;  // (C, A)
  std::vector<float> extras_;                     // (C, X)
  std::vector<std::int32_t> actions_;             // (C)
  std::vector<float> rewards_;                    // (C)
  std::vector<float> discounts_;                  // (C)
  std::vector<std::uint64_t> weights_versions_;   // (C)
};

}  // namespace ronda
