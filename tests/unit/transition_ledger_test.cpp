#include "deploy/transition_ledger.h"

#include <catch2/catch.hpp>

namespace ronda {
namespace {

ReplayStatus Status(std::uint64_t replay, std::uint64_t size, std::vector<ActorCredit> actors) {
  ReplayStatus status;
  status.replay_incarnation = replay;
  status.size = size;
  status.actors = std::move(actors);
  return status;
}

void CheckBalanced(const RunTotals& totals) {
  CHECK(totals.sent == totals.stored + totals.lost + totals.in_flight);
}

TEST_CASE("What a living actor has sent and the replay has not stored is in flight") {
  TransitionLedger sut;
  sut.OnActorReport(0, 11, 300, 0, 320);
  sut.OnStatus(Status(1, 256, {{0, 11, 256, 500}}));

  const RunTotals totals = sut.Totals();
  CheckBalanced(totals);
  CHECK(totals.sent == 300);
  CHECK(totals.in_flight == 44);
  CHECK(totals.lost == 0);
  CHECK(totals.decisions == 320);
}

TEST_CASE(
    "What a dead actor has sent and nobody has stored is lost, until a late message is stored") {
  TransitionLedger sut;
  sut.OnActorReport(0, 11, 300, 0, 320);
  sut.OnStatus(Status(1, 256, {{0, 11, 256, 500}}));
  sut.OnActorDeath(0, 11);
  CHECK(sut.Totals().lost == 44);

  sut.OnStatus(Status(1, 290, {{0, 11, 290, 500}}));
  sut.OnActorReport(0, 12, 10, 0, 10);
  const RunTotals totals = sut.Totals();
  CheckBalanced(totals);
  CHECK(totals.lost == 10);
  CHECK(totals.sent == 310);
  CHECK(totals.in_flight == 10);
}

TEST_CASE("A status that is newer than the actor's report says what was sent") {
  TransitionLedger sut;
  sut.OnActorReport(0, 11, 100, 0, 100);
  sut.OnStatus(Status(1, 180, {{0, 11, 180, 500}}));

  CheckBalanced(sut.Totals());
  CHECK(sut.Totals().sent == 180);
}

TEST_CASE("What an actor knows to be stored counts, also where the status has not come") {
  TransitionLedger sut;
  sut.OnActorReport(0, 11, 300, 256, 320);
  sut.OnActorDeath(0, 11);

  CheckBalanced(sut.Totals());
  CHECK(sut.Totals().stored == 256);
  CHECK(sut.Totals().lost == 44);
}

TEST_CASE("What a dead replay held is forgotten, and its successor counts nothing twice") {
  TransitionLedger sut;
  sut.OnActorReport(0, 11, 1000, 0, 1000);
  sut.OnStatus(Status(1, 900, {{0, 11, 900, 1500}}));
  sut.OnReplayDeath(1);
  sut.OnStatus(Status(2, 100, {{0, 11, 1000, 1500}}));

  const RunTotals totals = sut.Totals();
  CheckBalanced(totals);
  CHECK(totals.stored == 1000);
  CHECK(totals.forgotten == 900);
}

TEST_CASE("Totals of former sessions are carried on") {
  RunTotals before;
  before.sent = 50;
  before.stored = 40;
  before.lost = 10;
  before.decisions = 60;
  TransitionLedger sut(before);
  sut.OnActorReport(0, 99, 5, 0, 6);
  sut.OnStatus(Status(7, 5, {{0, 99, 5, 10}}));

  const RunTotals totals = sut.Totals();
  CheckBalanced(totals);
  CHECK(totals.sent == 55);
  CHECK(totals.decisions == 66);
}

TEST_CASE("Refusals are summed over processes, each counted by its last report") {
  TransitionLedger sut;
  sut.OnRefusals(11, 2);
  sut.OnRefusals(11, 5);
  sut.OnRefusals(12, 1);

  CHECK(sut.Totals().messages_refused == 6);
}

}  // namespace
}  // namespace ronda
