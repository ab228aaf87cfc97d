// Transitions over the loopback interface: window, limiter, a new replay, a former one, strangers.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "common/dds/experience_writer.h"
#include "common/dds/learner_endpoint.h"
#include "common/dds/status_reader.h"
#include "tests/dds/domains.h"
#include "tests/dds/small_replay.h"
#include "tests/dds/step_until.h"
#include "tests/dds/values.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

dds::ParticipantOptions Member(int domain, const std::string& name,
                               const std::string& run_id = TestRun()) {
  return {.domain = domain, .run_id = run_id, .name = name};
}

/// An actor that numbers its transitions, in the reward too.
struct NumberingActor {
  NumberingActor(dds::Participant& participant, std::uint64_t first_number = 1)
      : writer(participant, {.actor = 0, .incarnation = 50, .shape = kShape, .batch_size = 128}),
        next_number(first_number) {}

  /// Pushes up to `count` transitions while there is credit, then sends and listens.
  void Step(std::uint64_t count) {
    last_result = PushResult::kAccepted;
    for (; count > 0 && last_result == PushResult::kAccepted; --count) {
      last_result = writer.Push(NumberedTransition(next_number));
      if (last_result == PushResult::kAccepted) ++next_number;
    }
    writer.Poll();
    if (last_result == PushResult::kThrottled) writer.Wait(milliseconds(5));
  }

  dds::ExperienceWriter writer;
  std::uint64_t next_number;
  PushResult last_result = PushResult::kAccepted;
};

bool PushThrough(NumberingActor& actor, std::uint64_t last_number) {
  return StepUntil(
      [&] { actor.Step(std::min<std::uint64_t>(100, last_number + 1 - actor.next_number)); },
      [&] { return actor.next_number > last_number; });
}

std::vector<float> Numbers(std::uint64_t first, std::uint64_t last) {
  std::vector<float> numbers(last + 1 - first);
  std::iota(numbers.begin(), numbers.end(), static_cast<float>(first));
  return numbers;
}

TEST_CASE("20000 transitions arrive exactly once and in order") {
  SmallReplayThread replay(Member(kDeliveryDomain, "replay"), UnlimitedReplay(), 1);
  dds::Participant participant(Member(kDeliveryDomain, "actor"));
  NumberingActor sut(participant);

  const bool pushed = PushThrough(sut, 20'000);
  const bool drained = sut.writer.Drain(seconds(60));
  replay.Stop();

  REQUIRE(pushed);
  REQUIRE(drained);
  CHECK(sut.writer.sent() == 20'000);
  CHECK(sut.writer.confirmed() == 20'000);
  CHECK((replay.stored_rewards() == Numbers(1, 20'000)));
  CHECK(replay.last_status().stored == 20'000);
  CHECK(replay.last_status().doubled == 0);
}

TEST_CASE("the limiter stops the actor at its room, and samples let it go on") {
  ReplayServerConfig config = UnlimitedReplay();
  config.rate_limiter = {.min_size = 500, .samples_per_insert = 1.0, .error_buffer = 1500};
  SmallReplayThread replay(Member(kLimiterDomain, "replay"), config, 1);
  dds::Participant participant(Member(kLimiterDomain, "actor"));
  NumberingActor sut(participant);
  dds::StatusReader statuses(participant);
  ReplayStatus status;
  const auto step = [&] { sut.Step(100); };

  // Room for 500 + 1500 transitions while nobody samples: all of it is used, and no more.
  REQUIRE(StepUntil(step, [&] { return sut.writer.confirmed() == 2000; }));
  int looks = 0;
  REQUIRE(StepUntil(
      [&] {
        sut.Step(100);
        statuses.Wait(milliseconds(5));
      },
      [&] {
        while (statuses.Take(status)) ++looks;
        return looks >= 10 && status.inserts_wait == 1;
      }));
  CHECK(sut.last_result == PushResult::kThrottled);
  CHECK(sut.writer.confirmed() == 2000);
  CHECK(status.stored == 2000);
  CHECK(sut.writer.waiting_for() == "credit from the replay");

  // 10 mini-batches of 64 samples at 1 sample an insert make room for 640 more at least.
  dds::LearnerEndpoint learner(participant, {.learner_incarnation = 60, .batch_size = 64});
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    REQUIRE(learner.Next(seconds(60)) != nullptr);
  }
  CHECK(StepUntil(step, [&] { return sut.writer.confirmed() >= 2640; }));
}

TEST_CASE("a new replay gets what was not confirmed, and nothing twice") {
  dds::Participant participant(Member(kNewReplayDomain, "actor"));
  NumberingActor sut(participant);
  SmallReplayThread first(Member(kNewReplayDomain, "replay"), UnlimitedReplay(), 1);
  REQUIRE(PushThrough(sut, 5000));
  first.Stop();  // with an unknown part of the window on the way
  // Until the window is full: what is pushed now is for the next one.
  REQUIRE(
      StepUntil([&] { sut.Step(100); }, [&] { return sut.last_result == PushResult::kThrottled; }));
  const std::uint64_t confirmed = sut.writer.confirmed();

  SmallReplayThread second(Member(kNewReplayDomain, "replay"), UnlimitedReplay(), 2);
  REQUIRE(PushThrough(sut, 15'000));
  REQUIRE(sut.writer.Drain(seconds(60)));
  second.Stop();

  const std::uint64_t old_last = first.stored_rewards().size();
  CHECK((first.stored_rewards() == Numbers(1, old_last)));
  REQUIRE(!second.stored_rewards().empty());
  const auto new_first = static_cast<std::uint64_t>(second.stored_rewards().front());
  CHECK(new_first > confirmed);      // what was confirmed does not come again
  CHECK(new_first <= old_last + 1);  // and what is missing here, the first one had stored
  CHECK((second.stored_rewards() == Numbers(new_first, 15'000)));
  CHECK(second.last_status().doubled == 0);
}

TEST_CASE("a former replay that is still there is not listened to") {
  dds::Participant participant(Member(kFormerReplayDomain, "actor"));
  NumberingActor sut(participant);
  SmallReplayThread former(Member(kFormerReplayDomain, "former replay"), UnlimitedReplay(), 1);
  REQUIRE(PushThrough(sut, 3000));
  REQUIRE(sut.writer.Drain(seconds(60)));
  // The new one runs here, so that it is silent when this test says so.
  dds::Participant current_participant(Member(kFormerReplayDomain, "replay"));
  std::vector<float> stored;
  SmallReplay current(current_participant, UnlimitedReplay(), 2,
                      [&](float reward) { stored.push_back(reward); });
  dds::StatusReader statuses(participant);
  const auto hear_former = [&](int times, std::uint64_t push) {
    ReplayStatus status;
    return StepUntil(
        [&] {
          sut.Step(std::exchange(push, 0));
          statuses.Wait(milliseconds(5));
        },
        [&] {
          while (statuses.Take(status)) times -= status.replay_incarnation == 1 ? 1 : 0;
          return times <= 0;
        });
  };
  REQUIRE(StepUntil(
      [&] {
        current.Step();
        sut.Step(0);
      },
      [&] {  // both know each other
        return !current.Status().actors.empty() &&
               sut.writer.waiting_for() == "credit from the replay";
      }));

  // The former one alone is to be heard when the actor has something to send.
  REQUIRE(hear_former(5, 0));
  REQUIRE(hear_former(5, 100));
  REQUIRE(StepUntil(
      [&] {
        current.Step();
        sut.Step(0);
      },
      [&] { return sut.writer.confirmed() == 3100; }));
  former.Stop();

  CHECK((former.stored_rewards() == Numbers(1, 3000)));
  CHECK((stored == Numbers(3001, 3100)));
}

TEST_CASE("transitions that are not finite are refused, counted, and told of once") {
  SmallReplayThread replay(Member(kRefusalsDomain, "replay"), UnlimitedReplay(), 1);
  dds::Participant participant(Member(kRefusalsDomain, "actor"));
  NumberingActor sut(participant);
  dds::StatusReader statuses(participant);
  Transition bad = NumberedTransition(1);
  bad.reward = std::numeric_limits<float>::quiet_NaN();
  REQUIRE(StepUntil([&] { sut.writer.Wait(milliseconds(5)); },
                    [&] { return sut.writer.Push(bad) == PushResult::kAccepted; }));

  ReplayStatus status;
  const bool refused_twice = StepUntil(  // the second time as a repeat
      [&] {
        sut.writer.Poll();
        statuses.Wait(milliseconds(5));
      },
      [&] {
        while (statuses.Take(status)) continue;
        return status.messages_refused >= 2;
      });
  replay.Stop();

  CHECK(refused_twice);
  CHECK(replay.stored_rewards().empty());
  CHECK(sut.writer.confirmed() == 0);
  REQUIRE(replay.refusals().size() == 1);
  CHECK_THAT(replay.refusals()[0], Catch::Matchers::Contains("ronda/experience") &&
                                       Catch::Matchers::Contains("not finite"));
}

TEST_CASE("strangers in the same domain get nothing and give nothing") {
  SmallReplayThread our_replay(Member(kStrangersDomain, "replay", "ours"), UnlimitedReplay(), 1);
  dds::Participant our_participant(Member(kStrangersDomain, "actor", "ours"));
  dds::Participant their_participant(Member(kStrangersDomain, "actor", "theirs"));
  NumberingActor ours(our_participant);
  NumberingActor theirs(their_participant, 100'001);
  dds::StatusReader their_statuses(their_participant);

  // Without a replay of their own they stay alone, however long ours is served.
  REQUIRE(StepUntil(
      [&] {
        ours.Step(100);
        theirs.Step(100);
      },
      [&] { return ours.writer.confirmed() >= 5000; }));
  ReplayStatus status;
  CHECK_FALSE(their_statuses.Take(status));
  CHECK(theirs.writer.waiting_for() == "the replay");
  CHECK(theirs.last_result == PushResult::kThrottled);

  // With one, each side still has its own transitions only.
  SmallReplayThread their_replay(Member(kStrangersDomain, "replay", "theirs"), UnlimitedReplay(),
                                 2);
  REQUIRE(StepUntil(
      [&] {
        ours.Step(100);
        theirs.Step(100);
      },
      [&] { return theirs.writer.confirmed() >= 5000 && ours.writer.confirmed() >= 10'000; }));
  our_replay.Stop();
  their_replay.Stop();
  CHECK((our_replay.stored_rewards() == Numbers(1, our_replay.stored_rewards().size())));
  CHECK((their_replay.stored_rewards() ==
         Numbers(100'001, 100'000 + their_replay.stored_rewards().size())));
  CHECK(our_replay.last_status().actors.size() == 1);
  CHECK(their_replay.last_status().actors.size() == 1);
}

}  // namespace
}  // namespace ronda
