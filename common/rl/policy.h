#pragma once
// What chooses actions and can take new weights. Thread-compatible (it keeps scratch memory): one
// object for each thread.
#include <cstdint>
#include <span>

#include "common/base/rng.h"
#include "common/rl/messages.h"

namespace ronda {

enum class LoadResult {
  kLoaded,
  kOtherArchitecture,  // hash or length differ
  kNotFinite,
};

class Policy {
 public:
  virtual ~Policy() = default;
  /// The best legal action for one observation (O); ties go to the lowest index.
  virtual int Act(std::span<const float> observation,
                  std::span<const std::uint8_t> legal_actions) = 0;
  [[nodiscard]] virtual LoadResult Load(const WeightSnapshot& snapshot) = 0;
  virtual std::uint64_t architecture_hash() const = 0;
};

}  // namespace ronda
