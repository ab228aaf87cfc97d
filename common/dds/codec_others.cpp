#include <control.h>
#include <telemetry.h>
#include <weights.h>

#include "common/dds/codec.h"
#include "common/dds/codec_checks.h"

namespace ronda::dds {
namespace {

// idl/telemetry.idl; the generated strings would cut what is longer without a word.
constexpr std::size_t kMaxNameBytes = 64;
constexpr std::size_t kMaxStateBytes = 255;

bool TextsFit(const ProcessReport& value) {
  return value.role.size() <= kMaxNameBytes && value.state.size() <= kMaxStateBytes &&
         std::ranges::all_of(value.metrics, [](const auto& metric) {
           return metric.first.size() <= kMaxNameBytes;
         });
}

}  // namespace

bool Encode(const WeightSnapshot& value, wire::WeightSnapshot& message) {
  if (value.values.size() > wire::MAX_WEIGHTS) return false;
  message.protocol_version(kProtocolVersion);
  message.learner_incarnation(value.learner_incarnation);
  message.version(value.version);
  message.updates(value.updates);
  message.architecture_hash(value.architecture_hash);
  message.values(value.values);
  return true;
}

Fault Decode(const wire::WeightSnapshot& message, WeightSnapshot& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (message.values().empty() || message.values().size() > wire::MAX_WEIGHTS) return Fault::kSizes;
  if (!AllFinite(message.values())) return Fault::kNotFinite;
  value.learner_incarnation = message.learner_incarnation();
  value.version = message.version();
  value.updates = message.updates();
  value.architecture_hash = message.architecture_hash();
  value.values = message.values();
  return Fault::kNone;
}

bool Encode(const ProcessReport& value, wire::ProcessReport& message) {
  if (value.metrics.size() > wire::MAX_METRICS || !TextsFit(value)) return false;
  message.protocol_version(kProtocolVersion);
  message.role(value.role);
  message.process_index(value.index);
  message.incarnation(value.incarnation);
  message.pid(value.pid);
  message.state(value.state);
  message.metrics().resize(value.metrics.size());
  for (std::size_t i = 0; i < value.metrics.size(); ++i) {
    message.metrics()[i].name(value.metrics[i].first);
    message.metrics()[i].value(value.metrics[i].second);
  }
  return true;
}

Fault Decode(const wire::ProcessReport& message, ProcessReport& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (message.metrics().size() > wire::MAX_METRICS) return Fault::kSizes;
  if (message.pid() <= 0) return Fault::kRange;
  value.role = message.role().c_str();
  value.index = message.process_index();
  value.incarnation = message.incarnation();
  value.pid = message.pid();
  value.state = message.state().c_str();
  value.metrics.clear();
  for (const wire::Metric& metric : message.metrics()) {
    value.metrics.emplace_back(metric.name().c_str(), metric.value());
  }
  return Fault::kNone;
}

bool Encode(const RunControl& value, wire::RunControl& message) {
  message.protocol_version(kProtocolVersion);
  message.progress(value.progress);
  message.actors(value.actors);
  return true;
}

Fault Decode(const wire::RunControl& message, RunControl& value) {
  if (message.protocol_version() != kProtocolVersion) return Fault::kVersion;
  if (!(message.progress() >= 0.0 && message.progress() <= 1.0)) return Fault::kRange;
  if (message.actors() < 1) return Fault::kRange;
  value.progress = message.progress();
  value.actors = message.actors();
  return Fault::kNone;
}

}  // namespace ronda::dds
