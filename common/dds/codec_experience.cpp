#include <credit.h>
#include <experience.h>

#include "common/dds/codec.h"
#include "common/dds/codec_checks.h"

namespace ronda::dds {

const char* Describe(Fault fault) {
  switch (fault) {
    case Fault::kNone:
      return "nothing wrong";
    case Fault::kVersion:
      return "another protocol version, or no such message";
    case Fault::kSizes:
      return "arrays that do not fit their counts";
    case Fault::kRange:
      return "a value out of its range";
    case Fault::kNotFinite:
      return "a number that is not finite";
  }
  return "?";
}

bool Encode(const TransitionBatch& value, wire::TransitionBatch& message) {
  if (value.count > wire::MAX_TRANSITIONS ||
      value.observations.size() > wire::MAX_OBSERVATION_FLOATS ||
      value.next_legal_actions.size() > wire::MAX_LEGAL_FLAGS ||
      value.extras.size() > wire::MAX_EXTRA_FLOATS) {
    return false;
  }
  message.protocol_version(kProtocolVersion);
  message.actor(value.actor);
  message.actor_incarnation(value.actor_incarnation);
  message.replay_incarnation(value.replay_incarnation);
  message.first_sequence(value.first_sequence);
  message.oldest_unconfirmed(value.oldest_unconfirmed);
  RowsToMessage(value, message);
  message.agents(value.agents);
  return true;
}

Fault Decode(const wire::TransitionBatch& message, TransitionBatch& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (message.count() > wire::MAX_TRANSITIONS || !RowsFit(message) ||
      !HasSize(message.agents(), message.count())) {
    return Fault::kSizes;
  }
  if (message.oldest_unconfirmed() < 1 || message.first_sequence() < message.oldest_unconfirmed() ||
      message.first_sequence() > UINT64_MAX - wire::MAX_TRANSITIONS || !RowsInRange(message)) {
    return Fault::kRange;
  }
  if (!RowsFinite(message)) return Fault::kNotFinite;
  value.actor = message.actor();
  value.actor_incarnation = message.actor_incarnation();
  value.replay_incarnation = message.replay_incarnation();
  value.first_sequence = message.first_sequence();
  value.oldest_unconfirmed = message.oldest_unconfirmed();
  RowsToValue(message, value);
  value.agents = message.agents();
  return Fault::kNone;
}

bool Encode(const ReplayStatus& value, wire::ReplayStatus& message) {
  if (value.actors.size() > wire::MAX_ACTORS) return false;
  message.protocol_version(kProtocolVersion);
  message.replay_incarnation(value.replay_incarnation);
  message.size(value.size);
  message.capacity(value.capacity);
  message.stored(value.stored);
  message.sampled(value.sampled);
  message.repeats_dropped(value.repeats_dropped);
  message.doubled(value.doubled);
  message.messages_refused(value.messages_refused);
  message.inserts_wait(value.inserts_wait);
  message.samples_wait(value.samples_wait);
  message.actors().clear();
  message.actor_incarnations().clear();
  message.stored_through().clear();
  message.window_ends().clear();
  for (const ActorCredit& credit : value.actors) {
    message.actors().push_back(credit.actor);
    message.actor_incarnations().push_back(credit.actor_incarnation);
    message.stored_through().push_back(credit.stored_through);
    message.window_ends().push_back(credit.window_end);
  }
  return true;
}

Fault Decode(const wire::ReplayStatus& message, ReplayStatus& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  const std::size_t count = message.actors().size();
  if (count > wire::MAX_ACTORS || !HasSize(message.actor_incarnations(), count) ||
      !HasSize(message.stored_through(), count) || !HasSize(message.window_ends(), count)) {
    return Fault::kSizes;
  }
  if (message.size() > message.capacity() || message.inserts_wait() > 1 ||
      message.samples_wait() > 1) {
    return Fault::kRange;
  }
  value.replay_incarnation = message.replay_incarnation();
  value.size = message.size();
  value.capacity = message.capacity();
  value.stored = message.stored();
  value.sampled = message.sampled();
  value.repeats_dropped = message.repeats_dropped();
  value.doubled = message.doubled();
  value.messages_refused = message.messages_refused();
  value.inserts_wait = message.inserts_wait();
  value.samples_wait = message.samples_wait();
  value.actors.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (message.window_ends()[i] < message.stored_through()[i]) return Fault::kRange;
    value.actors.push_back({.actor = message.actors()[i],
                            .actor_incarnation = message.actor_incarnations()[i],
                            .stored_through = message.stored_through()[i],
                            .window_end = message.window_ends()[i]});
  }
  return Fault::kNone;
}

}  // namespace ronda::dds
