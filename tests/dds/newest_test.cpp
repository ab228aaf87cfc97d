// Topics of which the newest value counts: weights, reports, control, status.
#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <thread>

#include "common/dds/control_reader.h"
#include "common/dds/control_writer.h"
#include "common/dds/replay_endpoint.h"
#include "common/dds/report_reader.h"
#include "common/dds/report_writer.h"
#include "common/dds/status_reader.h"
#include "common/dds/weights_reader.h"
#include "common/dds/weights_writer.h"
#include "tests/dds/domains.h"
#include "tests/dds/step_until.h"
#include "tests/dds/values.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;

constexpr std::uint64_t kHash = 0x1111;

dds::ParticipantOptions Member(int domain, const std::string& name,
                               const std::string& run_id = TestRun()) {
  return {.domain = domain, .run_id = run_id, .name = name};
}

WeightSnapshot Weights(std::uint64_t version, std::uint64_t hash = kHash) {
  WeightSnapshot snapshot = GoodWeightSnapshot();
  snapshot.version = version;
  snapshot.architecture_hash = hash;
  return snapshot;
}

/// The next weights that a reader gives; nullopt: none came.
std::optional<WeightSnapshot> Next(dds::WeightsReader& reader) {
  const WeightSnapshot* newest = nullptr;
  StepUntil([&] { reader.Wait(milliseconds(5)); },
            [&] { return (newest = reader.Newest()) != nullptr; });
  return newest == nullptr ? std::nullopt : std::optional(*newest);
}

TEST_CASE("a late joiner gets the newest weights, unchanged, once") {
  dds::Participant learner(Member(kWeightsDomain, "learner"));
  dds::WeightsWriter writer(learner);
  for (std::uint64_t version = 1; version <= 3; ++version) writer.Publish(Weights(version));

  dds::Participant actor(Member(kWeightsDomain, "actor"));
  dds::WeightsReader sut(actor, kHash);
  const auto got = Next(sut);

  REQUIRE(got);
  CHECK(Same(*got, Weights(3)));
  CHECK(sut.Newest() == nullptr);
}

TEST_CASE("the largest weights that a message holds come through") {
  dds::Participant learner(Member(kLargeWeightsDomain, "learner"));
  dds::WeightsWriter writer(learner);
  WeightSnapshot large = Weights(1);
  large.values.resize(2'097'152, 0.5f);
  writer.Publish(large);

  dds::Participant actor(Member(kLargeWeightsDomain, "actor"));
  dds::WeightsReader sut(actor, kHash);
  const auto got = Next(sut);

  REQUIRE(got);
  CHECK(Same(*got, large));
}

TEST_CASE("weights of another architecture are refused, counted, and told of once a sender") {
  dds::Participant learner(Member(kForeignWeightsDomain, "learner"));
  dds::Participant actor(Member(kForeignWeightsDomain, "actor"));
  dds::WeightsReader sut(actor, kHash);
  std::vector<std::string> sentences;
  const auto refuse_two_of = [&](dds::WeightsWriter& writer, std::uint64_t version) {
    for (int i = 0; i < 2; ++i) {
      const std::uint64_t before = sut.messages_refused();
      writer.Publish(Weights(version++, 0x2222));
      REQUIRE(StepUntil(
          [&] {
            sut.Wait(milliseconds(5));
            CHECK(sut.Newest() == nullptr);
          },
          [&] { return sut.messages_refused() > before; }));
      for (auto& sentence : sut.TakeRefusals()) sentences.push_back(std::move(sentence));
    }
  };

  dds::WeightsWriter first(learner);
  refuse_two_of(first, 1);
  dds::WeightsWriter second(learner);
  refuse_two_of(second, 3);

  CHECK(sut.messages_refused() == 4);
  REQUIRE(sentences.size() == 2);
  CHECK_THAT(sentences[0], Catch::Matchers::Contains("0000000000002222") &&
                               Catch::Matchers::Contains("0000000000001111"));
  first.Publish(Weights(1));
  const auto good = Next(sut);
  REQUIRE(good);
  CHECK(good->version == 1);
}

TEST_CASE("weights of an older version are ignored") {
  dds::Participant learner(Member(kOlderWeightsDomain, "learner"));
  dds::Participant actor(Member(kOlderWeightsDomain, "actor"));
  dds::WeightsWriter writer(learner);
  dds::WeightsReader sut(actor, kHash);
  writer.Publish(Weights(5));
  REQUIRE(Next(sut));

  writer.Publish(Weights(4));
  dds::WeightsReader late(actor, kHash);  // proves that version 4 is there
  const WeightSnapshot* newest = nullptr;
  REQUIRE(StepUntil(
      [&] {
        late.Wait(milliseconds(5));
        CHECK(sut.Newest() == nullptr);
      },
      [&] { return (newest = late.Newest()) != nullptr; }));
  CHECK(newest->version == 4);
  CHECK(sut.Newest() == nullptr);

  writer.Publish(Weights(6));
  const auto next = Next(sut);
  REQUIRE(next);
  CHECK(next->version == 6);
}

TEST_CASE("weights of another run in the same domain do not come") {
  dds::Participant ours(Member(kStrangersWeightsDomain, "ours", "ours"));
  dds::Participant theirs(Member(kStrangersWeightsDomain, "theirs", "theirs"));
  dds::WeightsWriter our_writer(ours), their_writer(theirs);
  dds::WeightsReader our_reader(ours, kHash), their_reader(theirs, kHash);
  std::uint64_t version = 0;
  const auto publish_and_compare = [&] {
    ++version;
    their_writer.Publish(Weights(1'000'000 + version));  // newer: it would count if it came
    our_writer.Publish(Weights(version));
    const auto our_next = Next(our_reader);
    const auto their_next = Next(their_reader);
    REQUIRE(our_next);
    REQUIRE(their_next);
    CHECK(our_next->version == version);
    CHECK(their_next->version == 1'000'000 + version);
  };

  // Until members of each run that joined last have met theirs; those above have had longer to
  // meet.
  dds::Participant our_last(Member(kStrangersWeightsDomain, "our last", "ours"));
  dds::Participant their_last(Member(kStrangersWeightsDomain, "their last", "theirs"));
  dds::WeightsReader our_last_reader(our_last, kHash), their_last_reader(their_last, kHash);
  bool our_last_met = false, their_last_met = false;
  REQUIRE(StepUntil(publish_and_compare, [&] {
    our_last_met |= our_last_reader.Newest() != nullptr;
    their_last_met |= their_last_reader.Newest() != nullptr;
    return our_last_met && their_last_met;
  }));
  for (int round = 0; round < 20; ++round) publish_and_compare();
}

TEST_CASE("the launcher gets the last report of each process, also of one that has ended") {
  dds::Participant launcher(Member(kReportsDomain, "launcher"));
  dds::ReportReader sut(launcher);
  ProcessReport of_actor = GoodProcessReport();
  ProcessReport of_learner = GoodProcessReport();
  of_learner.role = "learner";
  of_learner.metrics = {{"loss", 0.125}};
  dds::Participant learner(Member(kReportsDomain, "learner"));
  dds::ReportWriter learner_writer(learner);
  learner_writer.Send(of_learner);

  std::map<std::string, ProcessReport> got;
  const auto take = [&] {
    ProcessReport report;
    while (sut.Take(report)) got[report.role] = report;
  };
  const auto arrived = [&](const std::string& role) {
    return StepUntil([&] { sut.Wait(milliseconds(5)); },
                     [&] {
                       take();
                       return got.contains(role);
                     });
  };
  {
    dds::Participant actor(Member(kReportsDomain, "actor"));
    dds::ReportWriter writer(actor);
    writer.Send(of_actor);
    REQUIRE(arrived("actor"));  // they have met
    of_actor.state = "stopped";
    writer.Send(of_actor);
    writer.Flush(milliseconds(10'000));
  }

  REQUIRE(arrived("learner"));
  REQUIRE(StepUntil([&] { sut.Wait(milliseconds(5)); },
                    [&] {
                      take();
                      return got["actor"].state == "stopped";
                    }));
  // What was said, and then what each had written to the only topic that it writes: its reports.
  const auto as_said = [](ProcessReport report, std::size_t metrics) {
    report.metrics.resize(metrics);
    return report;
  };
  CHECK(Same(as_said(got["actor"], of_actor.metrics.size()), of_actor));
  CHECK(Same(as_said(got["learner"], of_learner.metrics.size()), of_learner));
  const auto& metrics = got["actor"].metrics;
  REQUIRE(metrics.size() == of_actor.metrics.size() + 2);
  CHECK(metrics[metrics.size() - 2] == std::pair(std::string("messages ronda/report"), 1.0));
  CHECK(metrics.back().first == "bytes ronda/report");
  CHECK(metrics.back().second > 100.0);
}

TEST_CASE("everybody gets the launcher's newest word, once, late joiners too") {
  dds::Participant launcher(Member(kControlDomain, "launcher"));
  dds::ControlWriter writer(launcher);
  for (const double progress : {0.1, 0.2, 0.3}) REQUIRE(writer.Publish({.progress = progress}));

  dds::Participant actor(Member(kControlDomain, "actor"));
  dds::Participant learner(Member(kControlDomain, "learner"));
  for (dds::Participant* process : {&actor, &learner}) {
    dds::ControlReader sut(*process);
    const RunControl* word = nullptr;
    // (This reader has no Wait: its owner looks between two pieces of work.)
    REQUIRE(StepUntil([] { std::this_thread::yield(); },
                      [&] { return (word = sut.Newest()) != nullptr; }));
    CHECK(word->progress == 0.3);
    CHECK(sut.Newest() == nullptr);
  }
}

TEST_CASE("who only watches gets the replay's status, a late joiner the last one") {
  dds::Participant replay(Member(kStatusDomain, "replay"));
  dds::ReplayEndpoint endpoint(replay);
  ReplayStatus sent = GoodReplayStatus();
  for (sent.stored = 1; sent.stored < 50; ++sent.stored) REQUIRE(endpoint.SendStatus(sent));
  REQUIRE(endpoint.SendStatus(sent));

  dds::Participant launcher(Member(kStatusDomain, "launcher"));
  dds::StatusReader sut(launcher);
  ReplayStatus got;
  REQUIRE(StepUntil([&] { sut.Wait(milliseconds(5)); }, [&] { return sut.Take(got); }));

  CHECK(Same(got, sent));
  CHECK_FALSE(sut.Take(got));
}

}  // namespace
}  // namespace ronda
