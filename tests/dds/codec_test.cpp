// Encode and Decode: what is good comes through unchanged, what is not is refused for its reason.
#include "common/dds/codec.h"

#include <control.h>
#include <credit.h>
#include <experience.h>
#include <sampling.h>
#include <telemetry.h>
#include <weights.h>

#include <catch2/catch.hpp>
#include <limits>

#include "tests/dds/values.h"

namespace ronda::dds {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What Decode gives for a value that was encoded, in a value that held something else before.
template <typename Message, typename Value>
Value ThroughMessage(const Value& value, Value into) {
  Message message;
  REQUIRE(Encode(value, message));
  REQUIRE(Decode(message, into) == Fault::kNone);
  return into;
}

/// The reason for which an encoded value is refused after `change` was done to its message.
template <typename Message, typename Value, typename Change>
Fault FaultAfter(const Value& value, Change change) {
  Message message;
  REQUIRE(Encode(value, message));
  change(message);
  Value decoded;
  return Decode(message, decoded);
}

template <typename Change>
Fault TransitionsFault(Change change) {
  return FaultAfter<wire::TransitionBatch>(GoodTransitionBatch(5), change);
}

template <typename Change>
Fault SamplesFault(Change change) {
  return FaultAfter<wire::SampledBatch>(GoodSampledBatch(5), change);
}

template <typename Change>
Fault StatusFault(Change change) {
  return FaultAfter<wire::ReplayStatus>(GoodReplayStatus(), change);
}

TEST_CASE("transitions come through the codec unchanged, into memory that held others") {
  const TransitionBatch sent = GoodTransitionBatch(5);
  const auto got = ThroughMessage<wire::TransitionBatch>(sent, GoodTransitionBatch(9));
  CHECK(Same(got, sent));
}

TEST_CASE("an announcement of no transitions comes through") {
  const TransitionBatch sent = GoodTransitionBatch(0);
  CHECK(Same(ThroughMessage<wire::TransitionBatch>(sent, GoodTransitionBatch(2)), sent));
}

TEST_CASE("a message holds 256 transitions and no more") {
  const TransitionBatch most = GoodTransitionBatch(256);
  CHECK(Same(ThroughMessage<wire::TransitionBatch>(most, TransitionBatch()), most));
  wire::TransitionBatch message;
  CHECK_FALSE(Encode(GoodTransitionBatch(257), message));
}

TEST_CASE("mini-batches come through the codec unchanged, into memory that held others") {
  const SampledBatch sent = GoodSampledBatch(5);
  CHECK(Same(ThroughMessage<wire::SampledBatch>(sent, GoodSampledBatch(9)), sent));
}

TEST_CASE("a mini-batch holds 1024 samples and no more") {
  const SampledBatch most = GoodSampledBatch(1024);
  CHECK(Same(ThroughMessage<wire::SampledBatch>(most, SampledBatch()), most));
  wire::SampledBatch message;
  CHECK_FALSE(Encode(GoodSampledBatch(1025), message));
}

TEST_CASE("the other messages come through the codec unchanged") {
  CHECK(Same(ThroughMessage<wire::ReplayStatus>(GoodReplayStatus(), GoodReplayStatus()),
             GoodReplayStatus()));
  CHECK(Same(ThroughMessage<wire::SampleRequest>(GoodSampleRequest(), SampleRequest()),
             GoodSampleRequest()));
  CHECK(Same(ThroughMessage<wire::PriorityUpdate>(GoodPriorityUpdate(), PriorityUpdate()),
             GoodPriorityUpdate()));
  CHECK(Same(ThroughMessage<wire::WeightSnapshot>(GoodWeightSnapshot(), WeightSnapshot()),
             GoodWeightSnapshot()));
  CHECK(Same(ThroughMessage<wire::ProcessReport>(GoodProcessReport(), GoodProcessReport()),
             GoodProcessReport()));
  CHECK(Same(ThroughMessage<wire::RunControl>(GoodRunControl(), RunControl()), GoodRunControl()));
}

TEST_CASE("a metric may have no value yet") {
  ProcessReport report = GoodProcessReport();
  report.metrics = {{"loss", std::numeric_limits<double>::quiet_NaN()}};
  const auto got = ThroughMessage<wire::ProcessReport>(report, ProcessReport());
  CHECK(std::isnan(got.metrics.at(0).second));
}

TEST_CASE("what is too large for its message is not encoded") {
  ReplayStatus status;
  status.actors.resize(129);
  wire::ReplayStatus status_message;
  CHECK_FALSE(Encode(status, status_message));

  PriorityUpdate priorities;
  priorities.keys.resize(1025);
  priorities.priorities.resize(1025);
  wire::PriorityUpdate priorities_message;
  CHECK_FALSE(Encode(priorities, priorities_message));

  WeightSnapshot weights;
  weights.values.resize(2'097'153);
  wire::WeightSnapshot weights_message;
  CHECK_FALSE(Encode(weights, weights_message));

  ProcessReport report;
  report.metrics.resize(257);
  wire::ProcessReport report_message;
  CHECK_FALSE(Encode(report, report_message));
}

TEST_CASE("a report whose texts are too long for its message is not encoded") {
  wire::ProcessReport message;
  ProcessReport report = GoodProcessReport();
  report.state = std::string(256, 'x');
  CHECK_FALSE(Encode(report, message));

  report = GoodProcessReport();
  report.role = std::string(65, 'x');
  CHECK_FALSE(Encode(report, message));

  report = GoodProcessReport();
  report.metrics = {{std::string(65, 'x'), 1.0}};
  CHECK_FALSE(Encode(report, message));
}

TEST_CASE("a message of another protocol version is refused") {
  const auto other = [](auto& message) { message.protocol_version(kProtocolVersion + 1); };
  CHECK(TransitionsFault(other) == Fault::kVersion);
  CHECK(SamplesFault(other) == Fault::kVersion);
  CHECK(StatusFault(other) == Fault::kVersion);
  CHECK(FaultAfter<wire::SampleRequest>(GoodSampleRequest(), other) == Fault::kVersion);
  CHECK(FaultAfter<wire::PriorityUpdate>(GoodPriorityUpdate(), other) == Fault::kVersion);
  CHECK(FaultAfter<wire::WeightSnapshot>(GoodWeightSnapshot(), other) == Fault::kVersion);
  CHECK(FaultAfter<wire::ProcessReport>(GoodProcessReport(), other) == Fault::kVersion);
  CHECK(FaultAfter<wire::RunControl>(GoodRunControl(), other) == Fault::kVersion);
}

TEST_CASE("transitions whose arrays do not fit the count are refused") {
  CHECK(TransitionsFault([](auto& m) { m.observations().pop_back(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.actions().push_back(0); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.rewards().pop_back(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.discounts().pop_back(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.next_observations().clear(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.next_legal_actions().pop_back(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.extras().push_back(0); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.agents().pop_back(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.weights_versions().pop_back(); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.count(m.count() + 1); }) == Fault::kSizes);
  CHECK(TransitionsFault([](auto& m) { m.observation_size(4'000'000'000); }) == Fault::kSizes);
}

TEST_CASE("a count beyond the bound is refused even where the arrays fit it") {
  const auto grow = [](auto& m, std::uint32_t count) {
    m.count(count);
    m.observation_size(0);
    m.extras_size(0);
    m.observations().clear();
    m.next_observations().clear();
    m.extras().clear();
    m.actions().assign(count, 0);
    m.rewards().assign(count, 0.0f);
    m.discounts().assign(count, 1.0f);
    m.next_legal_actions().assign(std::size_t{count} * m.num_actions(), 1);
    m.weights_versions().assign(count, 0);
  };
  const auto transitions = [&](std::uint32_t count) {
    return TransitionsFault([&](auto& m) {
      grow(m, count);
      m.agents().assign(count, 0);
    });
  };
  const auto samples = [&](std::uint32_t count) {
    return SamplesFault([&](auto& m) {
      grow(m, count);
      m.keys().assign(count, 0);
      m.importance_weights().assign(count, 1.0f);
    });
  };
  CHECK(transitions(256) == Fault::kNone);
  CHECK(transitions(257) == Fault::kSizes);
  CHECK(samples(1024) == Fault::kNone);
  CHECK(samples(1025) == Fault::kSizes);
  CHECK(samples(0) == Fault::kSizes);
}

TEST_CASE("transitions with a value out of its range are refused") {
  CHECK(TransitionsFault([](auto& m) { m.actions()[4] = 2; }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.actions()[0] = -1; }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.discounts()[3] = 1.001f; }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.discounts()[3] = -0.001f; }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.discounts()[3] = kNan; }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.next_legal_actions()[9] = 2; }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.next_legal_actions()[8] = 0; }) == Fault::kNone);
  CHECK(TransitionsFault([](auto& m) {
          m.next_legal_actions()[6] = 0;
          m.next_legal_actions()[7] = 0;
        }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.oldest_unconfirmed(0); }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.first_sequence(95); }) == Fault::kRange);
  CHECK(TransitionsFault([](auto& m) { m.first_sequence(UINT64_MAX); }) == Fault::kRange);
}

TEST_CASE("transitions with a number that is not finite are refused") {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    CHECK(TransitionsFault([=](auto& m) { m.observations()[14] = bad; }) == Fault::kNotFinite);
    CHECK(TransitionsFault([=](auto& m) { m.next_observations()[0] = bad; }) == Fault::kNotFinite);
    CHECK(TransitionsFault([=](auto& m) { m.rewards()[2] = bad; }) == Fault::kNotFinite);
    CHECK(TransitionsFault([=](auto& m) { m.extras()[2] = bad; }) == Fault::kNotFinite);
  }
}

TEST_CASE("mini-batches are refused for the same reasons") {
  CHECK(SamplesFault([](auto& m) { m.keys().pop_back(); }) == Fault::kSizes);
  CHECK(SamplesFault([](auto& m) { m.importance_weights().push_back(1.0f); }) == Fault::kSizes);
  CHECK(SamplesFault([](auto& m) { m.observations().pop_back(); }) == Fault::kSizes);
  CHECK(SamplesFault([](auto& m) { m.actions()[1] = 2; }) == Fault::kRange);
  CHECK(SamplesFault([](auto& m) { m.discounts()[1] = 2.0f; }) == Fault::kRange);
  CHECK(SamplesFault([](auto& m) { m.next_legal_actions().assign(10, 0); }) == Fault::kRange);
  CHECK(SamplesFault([](auto& m) { m.importance_weights()[0] = 0.0f; }) == Fault::kRange);
  CHECK(SamplesFault([](auto& m) { m.importance_weights()[0] = 1.5f; }) == Fault::kRange);
  CHECK(SamplesFault([](auto& m) { m.importance_weights()[0] = kNan; }) == Fault::kRange);
  CHECK(SamplesFault([](auto& m) { m.rewards()[0] = kInfinity; }) == Fault::kNotFinite);
}

TEST_CASE("a status that contradicts itself is refused") {
  CHECK(StatusFault([](auto& m) { m.window_ends().pop_back(); }) == Fault::kSizes);
  CHECK(StatusFault([](auto& m) { m.stored_through().push_back(1); }) == Fault::kSizes);
  CHECK(StatusFault([](auto& m) { m.actor_incarnations().clear(); }) == Fault::kSizes);
  CHECK(StatusFault([](auto& m) { m.size(1001); }) == Fault::kRange);
  CHECK(StatusFault([](auto& m) { m.inserts_wait(2); }) == Fault::kRange);
  CHECK(StatusFault([](auto& m) { m.samples_wait(255); }) == Fault::kRange);
  CHECK(StatusFault([](auto& m) { m.window_ends()[0] = 99; }) == Fault::kRange);
}

TEST_CASE("requests, priorities, weights, reports and control out of their rules are refused") {
  const auto request = [](auto change) {
    return FaultAfter<wire::SampleRequest>(GoodSampleRequest(), change);
  };
  CHECK(request([](auto& m) { m.end_id(399); }) == Fault::kRange);
  CHECK(request([](auto& m) { m.batch_size(0); }) == Fault::kRange);
  CHECK(request([](auto& m) { m.batch_size(1025); }) == Fault::kRange);

  const auto priorities = [](auto change) {
    return FaultAfter<wire::PriorityUpdate>(GoodPriorityUpdate(), change);
  };
  CHECK(priorities([](auto& m) { m.keys().pop_back(); }) == Fault::kSizes);
  CHECK(priorities([](auto& m) { m.priorities()[1] = -1.0f; }) == Fault::kRange);
  CHECK(priorities([](auto& m) { m.priorities()[1] = kNan; }) == Fault::kNotFinite);

  const auto weights = [](auto change) {
    return FaultAfter<wire::WeightSnapshot>(GoodWeightSnapshot(), change);
  };
  CHECK(weights([](auto& m) { m.values().clear(); }) == Fault::kSizes);
  CHECK(weights([](auto& m) { m.values()[499] = -kInfinity; }) == Fault::kNotFinite);

  const auto report = [](auto change) {
    return FaultAfter<wire::ProcessReport>(GoodProcessReport(), change);
  };
  CHECK(report([](auto& m) { m.metrics().resize(257); }) == Fault::kSizes);
  CHECK(report([](auto& m) { m.pid(0); }) == Fault::kRange);

  const auto control = [](auto change) {
    return FaultAfter<wire::RunControl>(GoodRunControl(), change);
  };
  CHECK(control([](auto& m) { m.progress(1.01); }) == Fault::kRange);
  CHECK(control([](auto& m) { m.progress(-0.01); }) == Fault::kRange);
  CHECK(control([](auto& m) { m.progress(kNan); }) == Fault::kRange);
  CHECK(control([](auto& m) { m.actors(0); }) == Fault::kRange);
}

}  // namespace
}  // namespace ronda::dds
