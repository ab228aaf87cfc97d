// A replay process that is killed again and again: what the actor sends is stored all the same.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <numeric>

#include "common/dds/experience_writer.h"
#include "common/dds/learner_endpoint.h"
#include "common/run/child_process.h"
#include "tests/dds/domains.h"
#include "tests/dds/step_until.h"
#include "tests/dds/values.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// What one life of the replay program stored, and where it began.
struct Life {
  std::uint64_t incarnation = 0;
  std::uint64_t confirmed_before = 0;  // by its predecessors
  std::vector<float> stored;
};

class KilledReplay {
 public:
  KilledReplay(int domain, int socket_buffer_bytes)
      : domain_(domain), socket_buffer_bytes_(socket_buffer_bytes) {}

  ChildProcess Start(std::uint64_t incarnation) {
    return ChildProcess(std::filesystem::path(RONDA_BIN_DIR) / "dds_test_replay_program",
                        {std::to_string(domain_), TestRun(), std::to_string(incarnation),
                         std::to_string(socket_buffer_bytes_), File(incarnation).string()},
                        folder_ / "log");
  }

  bool HasStored(std::uint64_t incarnation) const {
    std::error_code none;
    const auto size = std::filesystem::file_size(File(incarnation), none);
    return !none && size > 0;
  }

  std::vector<float> Stored(std::uint64_t incarnation) const {
    std::ifstream file(File(incarnation), std::ios::binary);
    std::vector<float> rewards;
    for (float reward; file.read(reinterpret_cast<char*>(&reward), sizeof reward);) {
      rewards.push_back(reward);
    }
    return rewards;
  }

 private:
  std::filesystem::path File(std::uint64_t incarnation) const {
    return folder_ / fmt::format("stored-{}", incarnation);
  }

  int domain_;
  int socket_buffer_bytes_;
  TemporaryFolder folder_;
};

class NumberingActor {
 public:
  explicit NumberingActor(dds::Participant& participant)
      : writer(participant, {.actor = 0, .incarnation = 50, .shape = kShape, .batch_size = 128}) {}

  void Step(std::uint64_t last_number) {
    for (int i = 0; i < 100 && next_number_ <= last_number; ++i) {
      if (writer.Push(NumberedTransition(next_number_)) != PushResult::kAccepted) break;
      ++next_number_;
    }
    writer.Wait(milliseconds(1));  // sends too
  }

  dds::ExperienceWriter writer;

 private:
  std::uint64_t next_number_ = 1;
};

/// Starts the replay, kills it when it has confirmed `quarter` transitions more, three times; the
/// fourth one takes the rest.
std::vector<Life> SendThroughThreeKills(KilledReplay& replay, NumberingActor& actor,
                                        std::uint64_t quarter) {
  constexpr std::uint64_t kLives = 4;
  std::vector<Life> lives;
  for (std::uint64_t incarnation = 1; incarnation <= kLives; ++incarnation) {
    Life life{.incarnation = incarnation, .confirmed_before = 0, .stored = {}};
    ChildProcess child = replay.Start(incarnation);
    // An actor sends nothing to a replay before a turn later than the one in which it heard of it,
    // so what is confirmed in a turn before anything is stored was confirmed by predecessors.
    REQUIRE(StepUntil([&] { actor.Step(kLives * quarter); },
                      [&] {
                        const std::uint64_t confirmed = actor.writer.confirmed();
                        if (replay.HasStored(incarnation)) return true;
                        life.confirmed_before = confirmed;
                        return false;
                      }));
    const std::uint64_t goal = std::min(life.confirmed_before + quarter, kLives * quarter);
    const bool is_last = incarnation == kLives;
    REQUIRE(
        StepUntil([&] { actor.Step(kLives * quarter); },
                  [&] { return actor.writer.confirmed() >= (is_last ? kLives * quarter : goal); }));
    child.Signal(is_last ? SIGTERM : SIGKILL);
    const auto end = child.WaitFor(seconds(60));
    REQUIRE(end);
    CHECK(end->signal == (is_last ? 0 : SIGKILL));
    life.stored = replay.Stored(incarnation);
    lives.push_back(std::move(life));
  }
  return lives;
}

void CheckNothingLostOrDoubled(const std::vector<Life>& lives, std::uint64_t last_number) {
  std::uint64_t stored_through = 0;  // by any life so far
  for (const Life& life : lives) {
    CAPTURE(life.incarnation, life.confirmed_before, stored_through);
    REQUIRE(!life.stored.empty());
    // It begins at the oldest that was not confirmed, and goes on without a gap or a repeat.
    std::vector<float> expected(life.stored.size());
    std::iota(expected.begin(), expected.end(), static_cast<float>(life.confirmed_before + 1));
    CHECK((life.stored == expected));
    // What was confirmed before it, its predecessors had stored.
    CHECK(life.confirmed_before <= stored_through);
    stored_through = life.confirmed_before + life.stored.size();
  }
  CHECK(stored_through == last_number);
}

void CheckThreeKills(int domain, int buffer_bytes) {
  constexpr std::uint64_t kQuarter = 10'000;
  KilledReplay replay(domain, buffer_bytes);
  dds::Participant participant({.domain = domain,
                                .run_id = TestRun(),
                                .name = "actor",
                                .socket_buffer_bytes = buffer_bytes});
  NumberingActor sut(participant);

  const auto lives = SendThroughThreeKills(replay, sut, kQuarter);

  CHECK(sut.writer.confirmed() == 4 * kQuarter);
  CheckNothingLostOrDoubled(lives, 4 * kQuarter);
}

TEST_CASE("a replay that is killed three times costs no transition and doubles none") {
  CheckThreeKills(kKilledReplayDomain, 4 << 20);
}

TEST_CASE("the same with the socket buffers that the kernel gives without being told") {
  CheckThreeKills(kSmallBuffersDomain, 212'992);
}

TEST_CASE("no write waits for a reader that was killed") {
  KilledReplay replay(kDeadReaderDomain, 4 << 20);
  dds::Participant participant(
      {.domain = kDeadReaderDomain, .run_id = TestRun(), .name = "actor and learner"});
  NumberingActor actor(participant);
  dds::LearnerEndpoint sut(participant, {.learner_incarnation = 60, .batch_size = 64});
  ChildProcess child = replay.Start(1);
  REQUIRE(StepUntil([&] { actor.Step(1000); }, [&] { return actor.writer.confirmed() == 1000; }));
  REQUIRE(sut.Next(seconds(60)) != nullptr);  // so the two have met
  child.Signal(SIGKILL);
  REQUIRE(child.WaitFor(seconds(60)));

  // Many times what a writer keeps, within the 4 s for which the dead reader still counts as alive.
  // A writer that keeps all would stand still at the 65th.
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) {
    sut.Push({.replay_incarnation = 1, .keys = {1}, .priorities = {1.0f}});
  }
  CHECK(std::chrono::steady_clock::now() - began < seconds(2));
}

}  // namespace
}  // namespace ronda
