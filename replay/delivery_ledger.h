#pragma once
// The receiving half of confirmed delivery: which transitions of each actor are stored, and how far
// each may go.
//
// Sequence numbers of an actor's incarnation count from 1. A batch is taken only where it joins
// what is stored; what has come before is dropped and counted, what leaves a gap is ignored (the
// actor repeats it). An actor that this replay does not know announces itself, and starts at its
// oldest unconfirmed number. Windows never fall, and what is promised to actors but not used yet
// stays within the room that the rate limiter gives. The sending half is rl/delivery_window. A
// value; thread-compatible; O(actors) a grant.
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "common/rl/messages.h"

namespace ronda {

class DeliveryLedger {
 public:
  explicit DeliveryLedger(std::uint64_t replay_incarnation)
      : replay_incarnation_(replay_incarnation) {}

  /// How many leading transitions of the batch must be skipped as repeats; the rest is new and
  /// counts as stored from now on (the caller stores it). batch.count where nothing is new, or the
  /// batch is ignored.
  std::uint32_t Accept(const TransitionBatch& batch);

  /// Actors from this index on are leaving: they are granted nothing more, and what they were
  /// promised counts no longer. All are wanted at first.
  void set_actors(std::uint32_t wanted) { wanted_actors_ = wanted; }

  /// Extends windows to at most `window` beyond what is stored, all outstanding promises within
  /// `room`.
  void Grant(std::uint64_t room, std::uint64_t window);

  /// Newest incarnation of each actor first, then the replaced ones, as many as fit into one status
  /// message.
  std::vector<ActorCredit> Credits() const;

  std::uint64_t repeats_dropped() const { return repeats_dropped_; }
  std::uint64_t ignored() const { return ignored_; }
  /// Transitions that this ledger holds to be stored: stored_through less where each actor started,
  /// summed.
  std::uint64_t stored() const;
  std::size_t wanted_actors() const;  // of those that have announced themselves

 private:
  struct Entry {
    std::uint64_t started_after = 0;  // stored_through less what was stored here
    std::uint64_t stored_through = 0;
    std::uint64_t window_end = 0;
  };
  using Key = std::pair<std::uint32_t, std::uint64_t>;  // actor, incarnation

  std::uint64_t replay_incarnation_;
  std::map<Key, Entry> entries_;
  std::map<std::uint32_t, std::uint64_t> newest_;  // actor → its newest incarnation
  std::uint32_t wanted_actors_ = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t next_granted_ = 0;  // actors take turns to be first
  std::uint64_t repeats_dropped_ = 0;
  std::uint64_t ignored_ = 0;
};

}  // namespace ronda
