#pragma once
// Counts every transition of a run: sent = stored + lost + in flight, for each start of each actor
// (docs/protocol.md).
//
// Fed with what processes report and with their deaths; knows nothing of DDS or of clocks. What
// former sessions of the run folder counted is carried in. A value; thread-compatible.
#include <cstdint>
#include <map>
#include <utility>

#include "common/rl/messages.h"

namespace ronda {

/// Totals of the run folder, over all its sessions. Transitions, but for the last two.
struct RunTotals {
  std::uint64_t decisions = 0;
  std::uint64_t sent = 0;
  std::uint64_t stored = 0;
  std::uint64_t in_flight = 0;
  std::uint64_t lost = 0;       // sent by an actor that died, and never stored
  std::uint64_t doubled = 0;    // stored twice
  std::uint64_t forgotten = 0;  // stored by a replay that died
  std::uint64_t messages_refused = 0;
  std::uint64_t weights_version = 0;
};

class TransitionLedger {
 public:
  TransitionLedger() = default;
  explicit TransitionLedger(const RunTotals& before) : before_(before) {}

  void OnStatus(const ReplayStatus& status);
  /// `confirmed`: how far the actor knows its transitions to be stored; it hears the replay itself.
  void OnActorReport(std::uint32_t actor, std::uint64_t incarnation, std::uint64_t sent,
                     std::uint64_t confirmed, std::uint64_t decisions);
  /// Messages that a process other than the replay has refused, by its start.
  void OnRefusals(std::uint64_t incarnation, std::uint64_t messages);
  void OnWeightsVersion(std::uint64_t version);  // the largest counts
  void OnActorDeath(std::uint32_t actor, std::uint64_t incarnation);
  /// The replay of this incarnation died without being asked to stop: what it held is forgotten.
  void OnReplayDeath(std::uint64_t incarnation);

  RunTotals Totals() const;

 private:
  struct Actor {
    std::uint64_t sent = 0;
    std::uint64_t stored_through = 0;
    std::uint64_t decisions = 0;
    bool dead = false;
  };
  struct Replay {
    std::uint64_t size = 0;
    std::uint64_t doubled = 0;
    std::uint64_t messages_refused = 0;
    bool dead = false;
  };

  RunTotals before_;
  std::uint64_t weights_version_ = 0;
  std::map<std::pair<std::uint32_t, std::uint64_t>, Actor> actors_;
  std::map<std::uint64_t, Replay> replays_;
  std::map<std::uint64_t, std::uint64_t> refused_;  // messages, by incarnation
};

}  // namespace ronda
