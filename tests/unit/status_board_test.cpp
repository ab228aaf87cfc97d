#include "deploy/status_board.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace ronda {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const StatusBoard::TimePoint kStart = StatusBoard::TimePoint() + std::chrono::hours(1);

ProcessReport ActorReport(std::uint64_t incarnation, double decisions, double version) {
  return {.role = "actor",
          .index = 0,
          .incarnation = incarnation,
          .pid = 40,
          .state = "waiting for credit from the replay",
          .metrics = {{"decisions", decisions},
                      {"confirmed", decisions / 2},
                      {"weights_version", version},
                      {"messages ronda/experience", decisions / 10},
                      {"bytes ronda/experience", decisions * 100}}};
}

ChildFacts Actor(std::uint32_t index, std::uint64_t incarnation) {
  ChildFacts facts;
  facts.role = Role::kActor;
  facts.index = index;
  facts.pid = 40 + static_cast<pid_t>(index);
  facts.incarnation = incarnation;
  facts.started = kStart;
  return facts;
}

RunStatus Filled(const StatusBoard& board, const std::vector<ChildFacts>& children,
                 StatusBoard::TimePoint now) {
  RunStatus status;
  status.totals.weights_version = 12;
  board.Fill(children, now, status);
  return status;
}

const ChannelStatus& Channel(const RunStatus& status, const std::string& topic) {
  return *std::ranges::find(status.channels, topic, &ChannelStatus::topic);
}

TEST_CASE("Rates are what the last two seconds of reports say") {
  StatusBoard sut;
  sut.OnReport(ActorReport(7, 0, 3), kStart);
  sut.OnReport(ActorReport(7, 1000, 8), kStart + seconds(1));
  sut.OnReport(ActorReport(7, 5000, 10), kStart + seconds(3));

  const RunStatus status = Filled(sut, {Actor(0, 7)}, kStart + seconds(3));

  REQUIRE(status.processes.size() == 1);
  const ProcessStatus& actor = status.processes[0];
  CHECK(actor.rates_per_s.at("decisions") == 2000.0);
  CHECK(actor.rates_per_s.at("transitions") == 1000.0);
  CHECK(actor.weights_version == 10);
  CHECK(actor.lag_versions == 2.0);
  CHECK(actor.silent_s == 0.0);
  CHECK(Channel(status, "experience").messages == 500);
  CHECK(Channel(status, "experience").messages_per_s == 200.0);
  CHECK(Channel(status, "experience").bytes_per_s == 200'000.0);
  CHECK(Channel(status, "experience").waiting == "1 actor waits for credit from the replay");
  CHECK(status.problems.empty());
}

TEST_CASE("A silent process has no rate and is a problem after five seconds") {
  StatusBoard sut;
  sut.OnReport(ActorReport(7, 0, 3), kStart);
  sut.OnReport(ActorReport(7, 1000, 8), kStart + seconds(1));

  CHECK(Filled(sut, {Actor(0, 7)}, kStart + seconds(5)).problems.empty());
  const RunStatus status = Filled(sut, {Actor(0, 7)}, kStart + seconds(8));

  CHECK(status.processes[0].rates_per_s.at("decisions") == 0.0);
  REQUIRE(status.problems.size() == 1);
  CHECK(status.problems[0] == "actor 0 (process 40) has not reported for 7 s");
}

TEST_CASE("A dead process is named with how it died and when it comes back") {
  const StatusBoard sut;
  ChildFacts dead = Actor(3, 9);
  dead.pid = 0;
  dead.last_error = "signal 9 (Killed)";
  dead.start_again = kStart + milliseconds(1500);

  const RunStatus status = Filled(sut, {dead}, kStart);

  CHECK(status.processes[0].state == "dead, starting again in 1.5 s");
  REQUIRE(status.problems.size() == 1);
  CHECK(status.problems[0] ==
        "actor 3 is dead, starting again in 1.5 s: it ended with signal 9 (Killed)");
}

TEST_CASE("Processes that start or leave are no problem, and are told apart") {
  const StatusBoard sut;
  ChildFacts leaving = Actor(1, 5);
  leaving.leaving = true;

  const RunStatus status = Filled(sut, {leaving, Actor(0, 4)}, kStart + seconds(8));

  REQUIRE(status.processes.size() == 2);
  CHECK(status.processes[0].state == "starting");
  CHECK(status.processes[1].state == "leaving");
  CHECK(status.problems.empty());
}

TEST_CASE("What a channel carried counts on when its process is replaced") {
  StatusBoard sut;
  sut.OnReport(ActorReport(7, 1000, 3), kStart);
  sut.OnReport(ActorReport(8, 500, 3), kStart + seconds(9));

  CHECK(Channel(Filled(sut, {Actor(0, 8)}, kStart + seconds(9)), "experience").messages == 150);
}

}  // namespace
}  // namespace ronda
