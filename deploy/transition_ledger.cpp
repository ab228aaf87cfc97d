#include "deploy/transition_ledger.h"

#include <algorithm>

namespace ronda {

void TransitionLedger::OnStatus(const ReplayStatus& status) {
  Replay& replay = replays_[status.replay_incarnation];
  replay.size = status.size;
  replay.doubled = status.doubled;
  replay.messages_refused = status.messages_refused;
  for (const ActorCredit& credit : status.actors) {
    Actor& actor = actors_[{credit.actor, credit.actor_incarnation}];
    actor.stored_through = std::max(actor.stored_through, credit.stored_through);
  }
}

void TransitionLedger::OnActorReport(std::uint32_t index, std::uint64_t incarnation,
                                     std::uint64_t sent, std::uint64_t confirmed,
                                     std::uint64_t decisions) {
  Actor& actor = actors_[{index, incarnation}];
  actor.sent = std::max(actor.sent, sent);
  actor.stored_through = std::max(actor.stored_through, confirmed);
  actor.decisions = std::max(actor.decisions, decisions);
}

void TransitionLedger::OnRefusals(std::uint64_t incarnation, std::uint64_t messages) {
  refused_[incarnation] = std::max(refused_[incarnation], messages);
}

void TransitionLedger::OnWeightsVersion(std::uint64_t version) {
  weights_version_ = std::max(weights_version_, version);
}

void TransitionLedger::OnActorDeath(std::uint32_t index, std::uint64_t incarnation) {
  actors_[{index, incarnation}].dead = true;
}

void TransitionLedger::OnReplayDeath(std::uint64_t incarnation) {
  replays_[incarnation].dead = true;
}

RunTotals TransitionLedger::Totals() const {
  RunTotals totals = before_;
  totals.weights_version = std::max(totals.weights_version, weights_version_);
  for (const auto& [key, actor] : actors_) {
    // A report may be older than the status: what is stored was sent.
    const std::uint64_t sent = std::max(actor.sent, actor.stored_through);
    totals.decisions += std::max(actor.decisions, actor.stored_through);
    totals.sent += sent;
    totals.stored += actor.stored_through;
    (actor.dead ? totals.lost : totals.in_flight) += sent - actor.stored_through;
  }
  for (const auto& [incarnation, replay] : replays_) {
    totals.doubled += replay.doubled;
    totals.messages_refused += replay.messages_refused;
    if (replay.dead) totals.forgotten += replay.size;
  }
  for (const auto& [incarnation, messages] : refused_) totals.messages_refused += messages;
  return totals;
}

}  // namespace ronda
