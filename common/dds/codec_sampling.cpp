#include <sampling.h>

#include "common/dds/codec.h"
#include "common/dds/codec_checks.h"

namespace ronda::dds {

bool Encode(const SampleRequest& value, wire::SampleRequest& message) {
  message.protocol_version(kProtocolVersion);
  message.learner_incarnation(value.learner_incarnation);
  message.first_id(value.first_id);
  message.end_id(value.end_id);
  message.batch_size(value.batch_size);
  return true;
}

Fault Decode(const wire::SampleRequest& message, SampleRequest& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (message.end_id() < message.first_id() || message.batch_size() < 1 ||
      message.batch_size() > wire::MAX_SAMPLES) {
    return Fault::kRange;
  }
  value.learner_incarnation = message.learner_incarnation();
  value.first_id = message.first_id();
  value.end_id = message.end_id();
  value.batch_size = message.batch_size();
  return Fault::kNone;
}

bool Encode(const SampledBatch& value, wire::SampledBatch& message) {
  if (value.count > wire::MAX_SAMPLES ||
      value.observations.size() > wire::MAX_SAMPLE_OBSERVATION_FLOATS ||
      value.next_legal_actions.size() > wire::MAX_SAMPLE_LEGAL_FLAGS ||
      value.extras.size() > wire::MAX_SAMPLE_EXTRA_FLOATS) {
    return false;
  }
  message.protocol_version(kProtocolVersion);
  message.replay_incarnation(value.replay_incarnation);
  message.learner_incarnation(value.learner_incarnation);
  message.id(value.id);
  RowsToMessage(value, message);
  message.keys(value.keys);
  message.importance_weights(value.importance_weights);
  return true;
}

Fault Decode(const wire::SampledBatch& message, SampledBatch& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (message.count() < 1 || message.count() > wire::MAX_SAMPLES || !RowsFit(message) ||
      !HasSize(message.keys(), message.count()) ||
      !HasSize(message.importance_weights(), message.count())) {
    return Fault::kSizes;
  }
  for (const float weight : message.importance_weights()) {
    if (!(weight > 0.0f && weight <= 1.0f)) return Fault::kRange;
  }
  if (!RowsInRange(message)) return Fault::kRange;
  if (!RowsFinite(message)) return Fault::kNotFinite;
  value.replay_incarnation = message.replay_incarnation();
  value.learner_incarnation = message.learner_incarnation();
  value.id = message.id();
  RowsToValue(message, value);
  value.keys = message.keys();
  value.importance_weights = message.importance_weights();
  return Fault::kNone;
}

bool Encode(const PriorityUpdate& value, wire::PriorityUpdate& message) {
  if (value.keys.size() > wire::MAX_SAMPLES) return false;
  message.protocol_version(kProtocolVersion);
  message.replay_incarnation(value.replay_incarnation);
  message.keys(value.keys);
  message.priorities(value.priorities);
  return true;
}

Fault Decode(const wire::PriorityUpdate& message, PriorityUpdate& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (message.keys().size() > wire::MAX_SAMPLES ||
      !HasSize(message.priorities(), message.keys().size())) {
    return Fault::kSizes;
  }
  if (!AllFinite(message.priorities())) return Fault::kNotFinite;
  for (const float priority : message.priorities()) {
    if (priority < 0.0f) return Fault::kRange;
  }
  value.replay_incarnation = message.replay_incarnation();
  value.keys = message.keys();
  value.priorities = message.priorities();
  return Fault::kNone;
}

}  // namespace ronda::dds
