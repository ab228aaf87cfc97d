#pragma once
// The learner's duty cycle: take a mini-batch, update, publish the weights every so often, send
// priorities back.
//
// `Step` does at most one update and returns how many it did; it waits for a mini-batch at most as
// long as it is told. Times are passed in, so a test needs no clock. Update and version counters go
// on over restarts: a checkpoint holds them. Throws DivergenceError (from the algorithm).
// Thread-compatible.
#include <chrono>
#include <cstdint>

#include "common/rl/ports.h"
#include "learner/algorithm.h"

namespace ronda {

struct LearnerOptions {
  std::uint64_t incarnation = 0;
  std::uint64_t weights_version = 0;  // the last one published before, so that versions only grow
  std::chrono::milliseconds publish_every{100};
  bool send_priorities = false;  // where the replay samples by priority
};

class Learner {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// All references must outlive the learner. Publishes once at the first Step, so that actors have
  /// weights to act with.
  Learner(Algorithm& algorithm, BatchSource& batches, PrioritySink& priorities, WeightSink& weights,
          const LearnerOptions& options);

  int Step(TimePoint now, std::chrono::milliseconds wait_at_most);
  /// Publishes the present weights as a new version.
  void Publish(TimePoint now);

  std::uint64_t weights_version() const { return snapshot_.version; }
  const UpdateStats& last_update() const { return last_update_; }
  /// Mean over the last mini-batch of how many versions old the acting weights were.
  double policy_lag_versions() const { return policy_lag_versions_; }

 private:
  void MeasureLag(const SampledBatch& batch);

  Algorithm& algorithm_;
  BatchSource& batches_;
  PrioritySink& priorities_;
  WeightSink& weights_;
  LearnerOptions options_;
  UpdateStats last_update_;
  double policy_lag_versions_ = 0.0;
  bool published_ = false;
  TimePoint last_published_;
  WeightSnapshot snapshot_;
  PriorityUpdate priority_update_;
};

}  // namespace ronda
