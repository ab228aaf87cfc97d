#pragma once
// The sender's half of confirmed delivery: a sliding window with go-back-N repeats, like TCP's.
//
// Transitions get consecutive sequence numbers from 1 and are held in batches until the replay's
// status says that they are stored. Nothing is accepted beyond the window that the status grants,
// so whatever was accepted can be sent. A replay that does not name this (actor, incarnation) is
// told of it by an empty batch until it does; a new replay gets everything that is unconfirmed.
// What is never confirmed is sent again after `repeat_after` without progress.
//
// Rules: docs/protocol.md. No clock and no I/O of its own: time points are passed in and must not
// fall. Thread-compatible. Push is O(O + A + X); memory is bounded by the window.
#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "common/rl/messages.h"
#include "common/rl/ports.h"
#include "common/rl/transition.h"

namespace ronda {

struct DeliveryOptions {
  std::uint32_t actor = 0;
  std::uint64_t incarnation = 0;  // differs for every start of the actor
  TransitionShape shape;
  std::uint32_t batch_size = 256;                // transitions a batch, ≥ 1
  std::chrono::milliseconds max_age{10};         // a batch is closed at this age
  std::chrono::milliseconds repeat_after{1000};  // without progress
  std::chrono::milliseconds announce_every{200};
  std::size_t max_batches = 64;  // unconfirmed; what carries them may keep no more
  std::chrono::milliseconds replay_silent_after{
      5000};  // then an earlier replay may take over again
};

class DeliveryWindow {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit DeliveryWindow(const DeliveryOptions& options);

  /// kAccepted gives the transition the next sequence number; kThrottled: no credit for it.
  [[nodiscard]] PushResult Push(const Transition& transition, TimePoint now);

  /// Takes what the replay says: who it is, what is stored, how far the window reaches.
  void OnStatus(const ReplayStatus& status, TimePoint now);

  /// The batch to be sent now, or nullptr; valid until the next call of anything else. Once it has
  /// been sent, call MarkSent and ask for the next one; else the same is offered again later.
  const TransitionBatch* NextToSend(TimePoint now);
  void MarkSent(TimePoint now);

  /// Closes the batch that is being filled, whatever its age.
  void Flush();

  std::uint64_t accepted() const { return next_sequence_ - 1; }  // highest sequence number given
  std::uint64_t sent() const { return sent_; }            // highest sequence number ever handed out
  std::uint64_t confirmed() const { return confirmed_; }  // everything up to it is stored
  bool all_confirmed() const { return confirmed_ == accepted(); }
  std::uint64_t transitions_repeated() const { return repeated_; }
  bool replay_known() const { return replay_incarnation_.has_value(); }
  bool named() const { return named_; }  // the replay knows this actor
  bool throttled() const {
    return next_sequence_ > window_end_ || held_.size() >= options_.max_batches;
  }
  std::uint64_t replay_incarnation() const { return replay_incarnation_.value_or(0); }

 private:
  bool Adopt(std::uint64_t incarnation, TimePoint now);
  void Confirm(const ActorCredit& credit, TimePoint now);
  void SplitAtWindow(std::size_t index);

  DeliveryOptions options_;
  TransitionBatch open_;                // being filled
  TimePoint opened_at_;                 // when its first transition came
  std::deque<TransitionBatch> held_;    // closed, not confirmed, ascending
  std::size_t next_ = 0;                // held_[next_] is the next to be sent
  std::vector<TransitionBatch> spare_;  // emptied, their memory kept
  TransitionBatch announcement_;
  bool announcing_ = false;  // what NextToSend returned last
  std::optional<TimePoint> announced_at_;

  std::uint64_t next_sequence_ = 1;
  std::uint64_t sent_ = 0;
  std::uint64_t confirmed_ = 0;
  std::uint64_t repeated_ = 0;
  std::uint64_t window_end_ = 0;
  TimePoint
      progress_at_;  // of the last confirmation, or of the first sending after all was confirmed

  std::optional<std::uint64_t> replay_incarnation_;
  bool named_ = false;
  TimePoint heard_at_;                  // the last status of the current replay
  std::vector<std::uint64_t> retired_;  // replays of before: what they still say is stale
};

}  // namespace ronda
