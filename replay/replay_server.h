#pragma once
// The replay: takes transitions from actors, keeps them, and gives the learner mini-batches, in
// step by the rate limiter.
//
// Messages come in and go out as plain values, so the same code runs over DDS and in tests:
//   Insert(batch), Request(request), Reprioritise(update) for what has come in; NextBatch() and
//   Status() for what goes out. Nothing blocks. Malformed or foreign input is counted, never
//   thrown. Thread-compatible.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/base/rng.h"
#include "common/rl/messages.h"
#include "replay/delivery_ledger.h"
#include "replay/rate_limiter.h"
#include "replay/replay_buffer.h"
#include "replay/sampler.h"

namespace ronda {

struct ReplayServerConfig {
  TransitionShape shape;
  std::uint64_t capacity = 100'000;
  std::uint32_t batch_size = 128;
  std::uint64_t window = 1024;  // transitions that one actor may have on the way
  RateLimiterConfig rate_limiter;
  SamplerConfig sampler;
};

class ReplayServer {
 public:
  /// Throws InputError where actors and learner could wait for each other for ever.
  ReplayServer(const ReplayServerConfig& config, std::uint64_t incarnation, const Rng& rng);

  void Insert(const TransitionBatch& batch);
  void Request(const SampleRequest& request);
  void Reprioritise(const PriorityUpdate& update);
  /// How many actors are wanted; see DeliveryLedger::set_actors.
  void set_actors(std::uint32_t wanted) { ledger_.set_actors(wanted); }

  /// The next mini-batch that the learner asked for and the limiter allows; nullptr if there is
  /// none. Valid until the next call.
  const SampledBatch* NextBatch();

  /// Extends the actors' windows by what the limiter allows now, and says what is stored.
  ReplayStatus Status();

  std::uint64_t bytes() const {
    return config_.capacity * ReplayBuffer::BytesPerTransition(config_.shape);
  }
  /// One sentence for each sender whose transitions were refused, once.
  std::vector<std::string> TakeRefusals();

 private:
  std::uint64_t LargestWindow() const;

  ReplayServerConfig config_;
  std::uint64_t incarnation_;
  Rng rng_;
  ReplayBuffer buffer_;
  Sampler sampler_;
  RateLimiter limiter_;
  DeliveryLedger ledger_;
  std::optional<SampleRequest> request_;
  std::uint64_t next_id_ = 0;  // of the mini-batches of request_
  bool samples_wait_ = false;
  SampledBatch batch_;
  std::uint64_t messages_refused_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint64_t>> refused_senders_;
  std::vector<std::string> refusals_;
};

}  // namespace ronda
