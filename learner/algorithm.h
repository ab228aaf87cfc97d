#pragma once
// What turns a mini-batch into better weights: the seam between the learner and DQN, PPO and
// others.
//
// Deterministic: no randomness but what the constructor's seed gives, no clock. Thread-compatible.
// Errors: DivergenceError where a loss or gradient is not finite (weights are then as before the
// update), InputError where a batch does not fit the network, CheckpointError from Load.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/rl/messages.h"

namespace ronda {

struct UpdateStats {
  double loss = 0.0;                   // mean over the batch, importance-weighted
  double mean_absolute_td = 0.0;       // mean |target − Q|
  double mean_q = 0.0;                 // mean Q(s, a) of the chosen actions, before the update
  double gradient_norm = 0.0;          // before clipping
  std::span<const float> absolute_td;  // (B) |target − Q|, for priorities; until the next Update
};

/// Everything that the next update depends on, as plain values for a checkpoint.
struct AlgorithmState {
  struct Vector {
    std::string name;
    std::vector<float> values;
    friend bool operator==(const Vector&, const Vector&) = default;
  };
  std::string algorithm;  // "dqn", …
  std::uint64_t architecture_hash = 0;
  std::uint64_t updates = 0;
  std::uint64_t optimiser_steps = 0;
  double progress = 0.0;
  std::vector<Vector> vectors;  // names and lengths are the algorithm's own
  friend bool operator==(const AlgorithmState&, const AlgorithmState&) = default;
};

class Algorithm {
 public:
  virtual ~Algorithm() = default;
  virtual UpdateStats Update(const SampledBatch& batch) = 0;
  /// What actors need, as one flat vector; valid until the next Update or Load.
  virtual std::span<const float> parameters() const = 0;
  virtual std::uint64_t architecture_hash() const = 0;
  virtual std::uint64_t updates() const = 0;  // done so far, over restarts too
  /// Share of the training budget used, clamped to 0 … 1; drives the schedules.
  virtual void set_progress(double progress) = 0;
  virtual AlgorithmState Save() const = 0;
  virtual void Load(const AlgorithmState& state) = 0;
};

}  // namespace ronda
