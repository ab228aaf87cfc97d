#pragma once
// The seams between the domain and what carries its values: implemented over Fast DDS (common/dds)
// and in memory (tests).
//
// None of these blocks beyond the time that it is given. Thread-compatible: one thread uses an
// object.
#include <chrono>
#include <optional>

#include "common/rl/messages.h"

namespace ronda {

enum class PushResult {
  kAccepted,   // it has a sequence number and will be delivered, or counted as lost if this process
               // dies
  kThrottled,  // no credit: push the same transition again later
  kClosed,     // the sink is shutting down
};

/// Where an actor puts its transitions.
class TransitionSink {
 public:
  virtual ~TransitionSink() = default;
  [[nodiscard]] virtual PushResult Push(const Transition& transition) = 0;
  /// Sends a batch that is full or old enough, reads credit, repeats what timed out. Call it often.
  virtual void Poll() = 0;
  /// Returns early when credit has come or anything else may have changed.
  virtual void Wait(std::chrono::milliseconds at_most) = 0;
};

/// Where the learner gets its mini-batches.
class BatchSource {
 public:
  virtual ~BatchSource() = default;
  /// The next mini-batch, waiting for it at most so long; the reference is valid until the next
  /// call. nullptr: none came.
  virtual const SampledBatch* Next(std::chrono::milliseconds at_most) = 0;
};

class PrioritySink {
 public:
  virtual ~PrioritySink() = default;
  virtual void Push(const PriorityUpdate& update) = 0;  // may be lost
};

class WeightSink {
 public:
  virtual ~WeightSink() = default;
  virtual void Publish(const WeightSnapshot& snapshot) = 0;
};

class WeightSource {
 public:
  virtual ~WeightSource() = default;
  /// The newest snapshot, once; nullptr if nothing newer than the last one returned has come.
  virtual const WeightSnapshot* Newest() = 0;
};

}  // namespace ronda
