#include "replay/delivery_ledger.h"

#include <algorithm>
#include <iterator>

namespace ronda {
namespace {

constexpr std::size_t kMaxCredits = 128;  // as many as a status message holds

}  // namespace

std::uint32_t DeliveryLedger::Accept(const TransitionBatch& batch) {
  // What was meant for a former replay may name an oldest unconfirmed number that is out of date.
  if (batch.replay_incarnation != replay_incarnation_) {
    ++ignored_;
    return batch.count;
  }
  const Key key{batch.actor, batch.actor_incarnation};
  const std::uint64_t before = batch.oldest_unconfirmed - 1;
  auto entry = entries_.find(key);
  if (entry == entries_.end()) {
    entry = entries_.emplace(key, Entry{before, before, before}).first;
    auto& newest = newest_[batch.actor];
    newest = std::max(newest, batch.actor_incarnation);
  }
  Entry& actor = entry->second;
  if (before > actor.stored_through) {  // a former replay confirmed it: it will not come again
    actor.started_after += before - actor.stored_through;
    actor.stored_through = before;
    actor.window_end = std::max(actor.window_end, before);
  }
  if (batch.count == 0) return 0;
  const std::uint64_t end = batch.first_sequence + batch.count;
  if (batch.first_sequence > actor.stored_through + 1) {
    ++ignored_;
    return batch.count;
  }
  if (end <= actor.stored_through + 1) {
    repeats_dropped_ += batch.count;
    return batch.count;
  }
  const auto repeated = static_cast<std::uint32_t>(actor.stored_through + 1 - batch.first_sequence);
  repeats_dropped_ += repeated;
  actor.stored_through = end - 1;
  actor.window_end = std::max(actor.window_end, actor.stored_through);
  return repeated;
}

void DeliveryLedger::Grant(std::uint64_t room, std::uint64_t window) {
  const auto end = newest_.lower_bound(wanted_actors_);
  std::uint64_t promised = 0;
  for (auto it = newest_.begin(); it != end; ++it) {
    const Entry& entry = entries_.at({it->first, it->second});
    promised += entry.window_end - entry.stored_through;
  }
  if (promised >= room) return;
  std::uint64_t left = room - promised;
  const auto grant = [&](std::uint32_t actor, std::uint64_t incarnation) {
    Entry& entry = entries_.at({actor, incarnation});
    const std::uint64_t wanted = entry.stored_through + window;
    if (wanted <= entry.window_end) return;
    const std::uint64_t extension = std::min(wanted - entry.window_end, left);
    entry.window_end += extension;
    left -= extension;
  };
  const auto first = newest_.lower_bound(std::min(next_granted_, wanted_actors_));
  for (auto it = first; it != end; ++it) grant(it->first, it->second);
  for (auto it = newest_.begin(); it != first; ++it) grant(it->first, it->second);
  next_granted_ = first == end ? 0 : first->first + 1;
}

std::vector<ActorCredit> DeliveryLedger::Credits() const {
  std::vector<ActorCredit> credits;
  const auto append = [&](const Key& key, const Entry& entry) {
    if (credits.size() < kMaxCredits) {
      credits.push_back({key.first, key.second, entry.stored_through, entry.window_end});
    }
  };
  for (const auto& [actor, incarnation] : newest_) {
    append({actor, incarnation}, entries_.at({actor, incarnation}));
  }
  for (auto it = entries_.rbegin(); it != entries_.rend(); ++it) {
    if (newest_.at(it->first.first) != it->first.second) append(it->first, it->second);
  }
  return credits;
}

std::size_t DeliveryLedger::wanted_actors() const {
  return static_cast<std::size_t>(
      std::distance(newest_.begin(), newest_.lower_bound(wanted_actors_)));
}

std::uint64_t DeliveryLedger::stored() const {
  std::uint64_t stored = 0;
  for (const auto& [key, entry] : entries_) stored += entry.stored_through - entry.started_after;
  return stored;
}

}  // namespace ronda
