#pragma once
// Between plain values and wire types. Private to common/dds.
//
// Encode gives false where the value is too large for its message. Decode checks protocol version,
// sizes, ranges and finiteness, and says what is wrong instead of throwing; the value is then
// unspecified. Both reuse the memory of what they fill. Pure.
#include <cstdint>

#include "common/rl/messages.h"

namespace ronda::wire {
class TransitionBatch;
class ReplayStatus;
class SampleRequest;
class SampledBatch;
class PriorityUpdate;
class WeightSnapshot;
class ProcessReport;
class RunControl;
}  // namespace ronda::wire

namespace ronda::dds {

inline constexpr std::uint32_t kProtocolVersion = 2;

enum class Fault {
  kNone,
  kVersion,    // another protocol version, or bytes that are no such message
  kSizes,      // arrays that do not fit their counts
  kRange,      // a value out of its range
  kNotFinite,  // NaN or infinity where none may be
};
const char* Describe(Fault fault);

[[nodiscard]] bool Encode(const TransitionBatch& value, wire::TransitionBatch& message);
[[nodiscard]] bool Encode(const ReplayStatus& value, wire::ReplayStatus& message);
[[nodiscard]] bool Encode(const SampleRequest& value, wire::SampleRequest& message);
[[nodiscard]] bool Encode(const SampledBatch& value, wire::SampledBatch& message);
[[nodiscard]] bool Encode(const PriorityUpdate& value, wire::PriorityUpdate& message);
[[nodiscard]] bool Encode(const WeightSnapshot& value, wire::WeightSnapshot& message);
[[nodiscard]] bool Encode(const ProcessReport& value, wire::ProcessReport& message);
[[nodiscard]] bool Encode(const RunControl& value, wire::RunControl& message);

[[nodiscard]] Fault Decode(const wire::TransitionBatch& message, TransitionBatch& value);
[[nodiscard]] Fault Decode(const wire::ReplayStatus& message, ReplayStatus& value);
[[nodiscard]] Fault Decode(const wire::SampleRequest& message, SampleRequest& value);
[[nodiscard]] Fault Decode(const wire::SampledBatch& message, SampledBatch& value);
[[nodiscard]] Fault Decode(const wire::PriorityUpdate& message, PriorityUpdate& value);
[[nodiscard]] Fault Decode(const wire::WeightSnapshot& message, WeightSnapshot& value);
[[nodiscard]] Fault Decode(const wire::ProcessReport& message, ProcessReport& value);
[[nodiscard]] Fault Decode(const wire::RunControl& message, RunControl& value);

}  // namespace ronda::dds
