// Bytes that were cut or changed on the way: no message, or one whose value keeps its rules.
#include <controlPubSubTypes.h>
#include <creditPubSubTypes.h>
#include <experiencePubSubTypes.h>
#include <samplingPubSubTypes.h>
#include <telemetryPubSubTypes.h>
#include <weightsPubSubTypes.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "common/base/rng.h"
#include "common/dds/codec.h"
#include "common/dds/wire_type.h"
#include "tests/dds/values.h"

namespace ronda::dds {
namespace {

using Bytes = std::vector<std::uint8_t>;
using eprosima::fastrtps::rtps::octet;
using eprosima::fastrtps::rtps::SerializedPayload_t;

bool IsFinite(const std::vector<float>& values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

// What the rest of the program relies on, said once more and apart from the codec.
template <typename Batch>
bool RowsKeepTheRules(const Batch& v) {
  const std::size_t rows = v.count;
  const auto& [observation_size, num_actions, extras_size] = v.shape;
  if (v.observations.size() != rows * observation_size ||
      v.next_observations.size() != rows * observation_size ||
      v.next_legal_actions.size() != rows * num_actions || v.extras.size() != rows * extras_size ||
      v.actions.size() != rows || v.rewards.size() != rows || v.discounts.size() != rows ||
      v.weights_versions.size() != rows) {
    return false;
  }
  for (std::size_t row = 0; row < rows; ++row) {
    if (v.actions[row] < 0 || v.actions[row] >= static_cast<std::int64_t>(num_actions))
      return false;
    if (!(v.discounts[row] >= 0.0f) || !(v.discounts[row] <= 1.0f)) return false;
    int legal = 0;
    for (std::size_t action = 0; action < num_actions; ++action) {
      const int flag = v.next_legal_actions[row * num_actions + action];
      if (flag > 1) return false;
      legal += flag;
    }
    if (legal == 0) return false;
  }
  return IsFinite(v.observations) && IsFinite(v.next_observations) && IsFinite(v.rewards) &&
         IsFinite(v.extras);
}

bool KeepsTheRules(const TransitionBatch& v) {
  return v.count <= 256 && v.agents.size() == v.count && v.oldest_unconfirmed >= 1 &&
         v.first_sequence >= v.oldest_unconfirmed && RowsKeepTheRules(v);
}
bool KeepsTheRules(const SampledBatch& v) {
  return v.count >= 1 && v.count <= 1024 && v.keys.size() == v.count &&
         v.importance_weights.size() == v.count &&
         std::ranges::all_of(v.importance_weights, [](float w) { return w > 0 && w <= 1; }) &&
         RowsKeepTheRules(v);
}
bool KeepsTheRules(const ReplayStatus& v) {
  return v.size <= v.capacity && v.inserts_wait <= 1 && v.samples_wait <= 1 &&
         v.actors.size() <= 128 && std::ranges::all_of(v.actors, [](const ActorCredit& credit) {
           return credit.window_end >= credit.stored_through;
         });
}
bool KeepsTheRules(const SampleRequest& v) {
  return v.end_id >= v.first_id && v.batch_size >= 1 && v.batch_size <= 1024;
}
bool KeepsTheRules(const PriorityUpdate& v) {
  return v.keys.size() <= 1024 && v.priorities.size() == v.keys.size() && IsFinite(v.priorities) &&
         std::ranges::all_of(v.priorities, [](float priority) { return priority >= 0; });
}
bool KeepsTheRules(const WeightSnapshot& v) {
  return !v.values.empty() && v.values.size() <= 2'097'152 && IsFinite(v.values);
}
bool KeepsTheRules(const ProcessReport& v) {
  return v.pid > 0 && v.metrics.size() <= 256 && v.role.size() <= 64 && v.state.size() <= 255 &&
         std::ranges::all_of(v.metrics, [](const auto& m) { return m.first.size() <= 64; });
}
bool KeepsTheRules(const RunControl& v) {
  return v.progress >= 0 && v.progress <= 1 && v.actors >= 1;
}

template <typename PubSubType, typename Value>
Bytes Serialised(const Value& value) {
  WireType<PubSubType> type;
  typename PubSubType::type message;
  REQUIRE(Encode(value, message));
  SerializedPayload_t payload(type.getSerializedSizeProvider(&message)());
  REQUIRE(type.serialize(&message, &payload));
  return Bytes(payload.data, payload.data + payload.length);
}

/// What a reader makes of these bytes. The copy has exactly their size, so that a memory checker
/// sees a step beyond them.
template <typename PubSubType, typename Value>
Fault Received(const Bytes& bytes, typename PubSubType::type& message, Value& value) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  SerializedPayload_t payload(size);
  payload.length = size;
  std::ranges::copy(bytes, payload.data);
  WireType<PubSubType> type;
  CHECK(type.deserialize(&payload, &message));
  return Decode(message, value);
}

/// `Value` over its wire type; `good` gives one.
template <typename Type, typename ValueType, ValueType (*good)()>
struct Kind {
  using PubSubType = Type;
  using Value = ValueType;
  static Value Good() { return good(); }
};

TransitionBatch EightTransitions() { return GoodTransitionBatch(8); }
SampledBatch EightSamples() { return GoodSampledBatch(8); }

using Transitions = Kind<wire::TransitionBatchPubSubType, TransitionBatch, EightTransitions>;
using Samples = Kind<wire::SampledBatchPubSubType, SampledBatch, EightSamples>;
using Status = Kind<wire::ReplayStatusPubSubType, ReplayStatus, GoodReplayStatus>;
using Request = Kind<wire::SampleRequestPubSubType, SampleRequest, GoodSampleRequest>;
using Priorities = Kind<wire::PriorityUpdatePubSubType, PriorityUpdate, GoodPriorityUpdate>;
using Weights = Kind<wire::WeightSnapshotPubSubType, WeightSnapshot, GoodWeightSnapshot>;
using Report = Kind<wire::ProcessReportPubSubType, ProcessReport, GoodProcessReport>;
using Control = Kind<wire::RunControlPubSubType, RunControl, GoodRunControl>;

/// Every message that there is.
using Kinds =
    std::tuple<Transitions, Samples, Status, Request, Priorities, Weights, Report, Control>;

TEMPLATE_LIST_TEST_CASE("a message comes through its bytes unchanged", "", Kinds) {
  const auto sent = TestType::Good();
  typename TestType::PubSubType::type message;
  typename TestType::Value got;

  const Fault fault = Received<typename TestType::PubSubType>(
      Serialised<typename TestType::PubSubType>(sent), message, got);

  CHECK(fault == Fault::kNone);
  CHECK(Same(got, sent));
}

TEMPLATE_LIST_TEST_CASE("a message cut anywhere is refused as no such message", "", Kinds) {
  const Bytes whole = Serialised<typename TestType::PubSubType>(TestType::Good());
  typename TestType::PubSubType::type message;  // keeps what came before, as a reader's does
  typename TestType::Value value;
  const std::size_t step = whole.size() > 970 ? 97 : 7;

  for (std::size_t size = 0; size < whole.size(); size += step) {
    CAPTURE(size, whole.size());
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    CHECK(Received<typename TestType::PubSubType>(cut, message, value) == Fault::kVersion);
  }
}

TEMPLATE_LIST_TEST_CASE("a message with changed bytes never throws and never breaks its rules", "",
                        Kinds) {
  const Bytes whole = Serialised<typename TestType::PubSubType>(TestType::Good());
  typename TestType::PubSubType::type message;
  typename TestType::Value value;
  Rng rng(20'240'117);
  int refused = 0, taken = 0, broken = 0;

  for (int round = 0; round < 5000; ++round) {
    Bytes changed = whole;
    const std::uint32_t flips = 1 + rng.Below(4);
    for (std::uint32_t flip = 0; flip < flips; ++flip) {
      // Half of them among the first bytes, where encapsulation and counts are.
      const auto size = static_cast<std::uint32_t>(whole.size());
      const std::uint32_t place = rng.Below(rng.Below(2) == 0 ? std::min(size, 96u) : size);
      changed[place] = static_cast<std::uint8_t>(changed[place] ^ (1 + rng.Below(255)));
    }
    if (Received<typename TestType::PubSubType>(changed, message, value) != Fault::kNone) {
      ++refused;
      continue;
    }
    ++taken;
    if (!KeepsTheRules(value)) ++broken;
  }

  CHECK(broken == 0);
  CHECK(refused > 0);  // else nothing was tried
  CHECK(taken > 0);
}

}  // namespace
}  // namespace ronda::dds
