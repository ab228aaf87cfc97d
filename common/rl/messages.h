#pragma once
// The other values that cross between actor, replay, learner and launcher. Plain structs; the wire
// never shows here.
//
// Delivery is confirmed end to end: the replay's status says for each actor what is stored
// (`stored_through`) and how far it may go (`window_end`); what is not confirmed is sent again
// after a time-out or to a new replay. See docs/protocol.md.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/rl/transition.h"

namespace ronda {

struct ActorCredit {
  std::uint32_t actor = 0;
  std::uint64_t actor_incarnation = 0;
  std::uint64_t stored_through = 0;  // every sequence number up to it is stored
  std::uint64_t window_end = 0;      // the highest sequence number that may be sent; never falls
};

/// What the replay says of itself: to actors the credit, to the learner its identity, to the
/// launcher its counters.
struct ReplayStatus {
  std::uint64_t replay_incarnation = 0;
  std::uint64_t size = 0;  // transitions held
  std::uint64_t capacity = 0;
  std::uint64_t stored = 0;            // transitions ever inserted by this incarnation
  std::uint64_t sampled = 0;           // transitions ever sampled by this incarnation
  std::uint64_t repeats_dropped = 0;   // transitions that came again and were not stored
  std::uint64_t doubled = 0;           // transitions stored twice: must stay 0
  std::uint64_t messages_refused = 0;  // malformed, or of another shape
  std::uint8_t inserts_wait = 0;  // 1: the rate limiter holds the actors (the learner is behind)
  std::uint8_t samples_wait =
      0;  // 1: the rate limiter holds the learner (too little, or the actors are behind)
  std::vector<ActorCredit> actors;
};

/// "Of my mini-batches numbered first_id … end_id − 1, send those that you have not sent." Newest
/// replaces all before.
struct SampleRequest {
  std::uint64_t learner_incarnation = 0;
  std::uint64_t first_id = 0;
  std::uint64_t end_id = 0;
  std::uint32_t batch_size = 0;  // B
};

/// A mini-batch: struct of row-major arrays.
struct SampledBatch {
  std::uint64_t replay_incarnation = 0;
  std::uint64_t learner_incarnation = 0;
  std::uint64_t id = 0;
  TransitionShape shape;
  std::uint32_t count = 0;                       // B
  std::vector<float> observations;               // (B, O)
  std::vector<std::int32_t> actions;             // (B)
  std::vector<float> rewards;                    // (B)
  std::vector<float> discounts;                  // (B)
  std::vector<float> next_observations;          // (B, O)
  std::vector<std::uint8_t> next_legal_actions;  // (B, A)
  std::vector<float> extras;                     // (B, X)
  std::vector<std::uint64_t> weights_versions;   // (B)
  std::vector<std::uint64_t> keys;               // (B) to send priorities back
  std::vector<float> importance_weights;         // (B) in (0, 1]
};

struct PriorityUpdate {
  std::uint64_t replay_incarnation = 0;
  std::vector<std::uint64_t> keys;
  std::vector<float> priorities;  // finite, ≥ 0
};

/// All weights are one flat vector; they load only where the architecture hashes agree.
struct WeightSnapshot {
  std::uint64_t learner_incarnation = 0;
  std::uint64_t version = 0;  // grows with every publication, over restarts too
  std::uint64_t updates = 0;  // gradient steps behind these weights, over restarts too
  std::uint64_t architecture_hash = 0;
  std::vector<float> values;
};

/// Metrics whose names begin so count what the process has written to the topic that follows.
inline constexpr const char* kMessagesMetric = "messages ";
inline constexpr const char* kBytesMetric = "bytes ";

/// What a process reports of itself, a few times a second and once at its end.
struct ProcessReport {
  std::string role;  // actor, replay, learner
  std::uint32_t index = 0;
  std::uint64_t incarnation = 0;
  std::int64_t pid = 0;
  std::string state;  // "running", or what it waits for
  std::vector<std::pair<std::string, double>> metrics;
};

/// What the launcher tells everybody.
struct RunControl {
  double progress = 0.0;  // share of the training budget that is used, 0 … 1; drives the schedules
  std::uint32_t actors = 1;  // wanted; those with this index or a larger one are leaving
};

}  // namespace ronda
