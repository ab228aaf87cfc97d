// Mini-batches and priorities over the loopback interface.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <thread>

#include "common/dds/experience_writer.h"
#include "common/dds/learner_endpoint.h"
#include "common/dds/replay_endpoint.h"
#include "tests/dds/domains.h"
#include "tests/dds/small_replay.h"
#include "tests/dds/step_until.h"
#include "tests/dds/values.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

dds::ParticipantOptions Member(int domain, const std::string& name) {
  return {.domain = domain, .run_id = TestRun(), .name = name};
}

/// Sends the transitions numbered from 1; all of them are stored when it returns true.
bool FillReplay(dds::ExperienceWriter& writer, std::uint64_t count) {
  std::uint64_t next = 1;
  const bool pushed = StepUntil(
      [&] {
        writer.Wait(milliseconds(5));
        while (next <= count && writer.Push(NumberedTransition(next)) == PushResult::kAccepted) {
          ++next;
        }
      },
      [&] { return next > count; });
  return pushed && writer.Drain(seconds(60));
}

/// Each row is what the actor sent under the number that its key stands for: a replay that began
/// empty gives key n − 1 to the n-th transition.
bool RowsMatchTheirKeys(const SampledBatch& batch) {
  TransitionBatch expected;
  expected.shape = kShape;
  for (const std::uint64_t key : batch.keys) expected.Append(NumberedTransition(key + 1));
  return batch.rewards == expected.rewards && batch.observations == expected.observations &&
         batch.actions == expected.actions && batch.discounts == expected.discounts &&
         batch.next_observations == expected.next_observations &&
         batch.next_legal_actions == expected.next_legal_actions &&
         batch.extras == expected.extras && batch.weights_versions == expected.weights_versions;
}

TEST_CASE("mini-batches come in order of their ids and hold what the actor sent") {
  SmallReplayThread replay(Member(kSamplesDomain, "replay"), UnlimitedReplay(), 1);
  dds::Participant participant(Member(kSamplesDomain, "actor and learner"));
  dds::ExperienceWriter actor(participant, {.actor = 0, .incarnation = 50, .shape = kShape});
  REQUIRE(FillReplay(actor, 1000));
  dds::LearnerEndpoint sut(participant,
                           {.learner_incarnation = 60, .batch_size = 64, .outstanding = 8});

  std::set<std::uint64_t> keys;
  std::vector<std::uint64_t> ids;
  int wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const SampledBatch* batch = sut.Next(seconds(60));
    REQUIRE(batch != nullptr);
    REQUIRE(batch->count == 64);
    if (!RowsMatchTheirKeys(*batch)) ++wrong;
    keys.insert(batch->keys.begin(), batch->keys.end());
    ids.push_back(batch->id);
  }

  CHECK(wrong == 0);
  CHECK(std::ranges::is_sorted(ids));
  CHECK(std::set(ids.begin(), ids.end()).size() == ids.size());
  // 19 200 uniform draws of 1000: all of them but for odds of 1000 · exp(−19.2) < 1e−5.
  CHECK(keys.size() == 1000);
}

TEST_CASE("priorities reach the replay that gave the keys, and no other") {
  ReplayServerConfig config = UnlimitedReplay();
  config.sampler = {.prioritised = true, .alpha = 1.0, .beta = 0.0, .priority_floor = 1e-3};
  SmallReplayThread replay(Member(kPrioritiesDomain, "replay"), config, 5);
  dds::Participant participant(Member(kPrioritiesDomain, "actor and learner"));
  dds::ExperienceWriter actor(participant, {.actor = 0, .incarnation = 50, .shape = kShape});
  REQUIRE(FillReplay(actor, 200));
  dds::LearnerEndpoint sut(participant, {.learner_incarnation = 60, .batch_size = 64});
  const auto draws_of_a_batch = [&](std::uint64_t key) -> std::int64_t {
    const SampledBatch* batch = sut.Next(seconds(60));
    REQUIRE(batch != nullptr);
    REQUIRE(batch->replay_incarnation == 5);
    return std::ranges::count(batch->keys, key);
  };

  // Key 33 is for another replay, key 7 for this one; the order on the wire is kept, so once 7 is
  // drawn almost always, 33 has been looked at.
  for (std::uint64_t i = 0; i < 2; ++i) {
    sut.Push({.replay_incarnation = i == 0 ? 4u : 5u,
              .keys = {i == 0 ? 33u : 7u},
              .priorities = {1e9f}});
  }
  // 64 of 64 draws but for odds of 2e−7 a draw.
  REQUIRE(StepUntil([] {}, [&] { return draws_of_a_batch(7) == 64; }));
  CHECK(draws_of_a_batch(7) == 64);
  CHECK(draws_of_a_batch(33) == 0);
}

TEST_CASE("the learner goes on with a new replay") {
  dds::Participant participant(Member(kNewReplayForLearnerDomain, "actor and learner"));
  dds::ExperienceWriter actor(participant, {.actor = 0, .incarnation = 50, .shape = kShape});
  dds::LearnerEndpoint sut(participant, {.learner_incarnation = 60, .batch_size = 64});
  std::uint64_t last_id = 0;
  {
    SmallReplayThread first(Member(kNewReplayForLearnerDomain, "replay"), UnlimitedReplay(), 1);
    REQUIRE(FillReplay(actor, 500));
    for (int i = 0; i < 20; ++i) {
      const SampledBatch* batch = sut.Next(seconds(60));
      REQUIRE(batch != nullptr);
      CHECK(batch->replay_incarnation == 1);
      last_id = batch->id;
    }
  }

  SmallReplayThread second(Member(kNewReplayForLearnerDomain, "replay"), UnlimitedReplay(), 2);
  std::uint64_t next = 501;
  REQUIRE(StepUntil(
      [&] {
        actor.Wait(milliseconds(5));
        if (actor.Push(NumberedTransition(next)) == PushResult::kAccepted) ++next;
      },
      [&] { return actor.confirmed() >= 600; }));
  int of_the_second = 0;
  REQUIRE(StepUntil([] {},
                    [&] {
                      const SampledBatch* batch = sut.Next(seconds(60));
                      REQUIRE(batch != nullptr);
                      REQUIRE(batch->id > last_id);
                      last_id = batch->id;
                      if (batch->replay_incarnation == 2) ++of_the_second;
                      return of_the_second == 20;
                    }));
}

TEST_CASE("what does not come is asked for again, within one long wait too") {
  dds::Participant replay(Member(kLostSamplesDomain, "replay"));
  dds::ReplayEndpoint endpoint(replay);
  int requests = 0;
  std::jthread answers([&](std::stop_token stop) {  // the first two are as good as lost
    SampleRequest request;
    while (!stop.stop_requested()) {
      endpoint.Wait(milliseconds(5));
      while (endpoint.TakeRequest(request)) ++requests;
      if (requests < 3) continue;
      SampledBatch batch = GoodSampledBatch(64);
      batch.learner_incarnation = request.learner_incarnation;
      batch.id = request.first_id;
      endpoint.SendBatch(batch);
    }
  });
  dds::Participant participant(Member(kLostSamplesDomain, "learner"));
  dds::LearnerEndpoint sut(participant, {.learner_incarnation = 60, .batch_size = 64});

  const SampledBatch* batch = sut.Next(seconds(60));

  CHECK(batch != nullptr);
  answers.request_stop();
  answers.join();
  CHECK(requests >= 3);
}

TEST_CASE("a learner's successor is served, and not with what its predecessor asked for") {
  SmallReplayThread replay(Member(kNewLearnerDomain, "replay"), UnlimitedReplay(), 1);
  dds::Participant participant(Member(kNewLearnerDomain, "actor and learner"));
  dds::ExperienceWriter actor(participant, {.actor = 0, .incarnation = 50, .shape = kShape});
  REQUIRE(FillReplay(actor, 500));
  {
    dds::LearnerEndpoint predecessor(participant, {.learner_incarnation = 60, .batch_size = 64});
    for (int i = 0; i < 5; ++i) REQUIRE(predecessor.Next(seconds(60)) != nullptr);
  }

  dds::LearnerEndpoint sut(participant, {.learner_incarnation = 61, .batch_size = 64});
  for (int i = 0; i < 20; ++i) {
    const SampledBatch* batch = sut.Next(seconds(60));
    REQUIRE(batch != nullptr);
    CHECK(batch->learner_incarnation == 61);
  }
}

}  // namespace
}  // namespace ronda
