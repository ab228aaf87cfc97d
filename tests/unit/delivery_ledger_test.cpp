#include "replay/delivery_ledger.h"

#include <catch2/catch.hpp>

namespace ronda {
namespace {

constexpr std::uint64_t kReplay = 77;

TransitionBatch Batch(std::uint64_t first, std::uint32_t count, std::uint64_t oldest = 1,
                      std::uint32_t actor = 0, std::uint64_t incarnation = 1) {
  TransitionBatch batch;
  batch.actor = actor;
  batch.actor_incarnation = incarnation;
  batch.replay_incarnation = kReplay;
  batch.first_sequence = first;
  batch.oldest_unconfirmed = oldest;
  batch.count = count;
  return batch;
}

TEST_CASE(
    "A batch that joins is new, one that repeats is dropped, an overlap is trimmed, a gap is "
    "ignored") {
  DeliveryLedger sut(kReplay);
  sut.Accept(Batch(1, 0));

  CHECK(sut.Accept(Batch(1, 10)) == 0);
  CHECK(sut.Accept(Batch(1, 10)) == 10);
  CHECK(sut.Accept(Batch(6, 10)) == 5);
  CHECK(sut.Accept(Batch(17, 4)) == 4);
  CHECK(sut.Accept(Batch(16, 4)) == 0);

  CHECK(sut.stored() == 19);
  CHECK(sut.repeats_dropped() == 15);
  CHECK(sut.ignored() == 1);
  CHECK(sut.Credits().at(0).stored_through == 19);
}

TEST_CASE("An actor that is new to this replay starts at its oldest unconfirmed transition") {
  DeliveryLedger sut(kReplay);
  sut.Accept(Batch(41, 0, 41));

  CHECK(sut.Accept(Batch(51, 10, 41)) == 10);
  CHECK(sut.Accept(Batch(41, 10, 41)) == 0);
  CHECK(sut.Accept(Batch(51, 10, 41)) == 0);
  CHECK(sut.stored() == 20);
}

TEST_CASE("A batch that was meant for another replay is ignored") {
  DeliveryLedger sut(kReplay);
  sut.Accept(Batch(1, 0));
  TransitionBatch batch = Batch(1, 5);
  batch.replay_incarnation = kReplay - 1;

  CHECK(sut.Accept(batch) == 5);
  CHECK(sut.stored() == 0);
}

TEST_CASE("A late batch for a former replay does not register an actor at an outdated number") {
  DeliveryLedger sut(kReplay);
  TransitionBatch late = Batch(11, 10, 11);
  late.replay_incarnation = kReplay - 1;
  sut.Accept(late);

  CHECK(sut.Credits().empty());
}

TEST_CASE("What a former replay confirmed is not waited for, nor counted as stored here") {
  DeliveryLedger sut(kReplay);
  sut.Accept(Batch(11, 0, 11));

  CHECK(sut.Accept(Batch(31, 10, 31)) == 0);
  CHECK(sut.stored() == 10);
  CHECK(sut.Credits().at(0).stored_through == 40);
}

TEST_CASE("Windows never fall and what is promised stays within the room") {
  DeliveryLedger sut(kReplay);
  for (std::uint32_t actor = 0; actor < 3; ++actor) sut.Accept(Batch(1, 0, 1, actor));

  sut.Grant(100, 64);
  std::uint64_t promised = 0;
  for (const auto& credit : sut.Credits()) promised += credit.window_end;
  CHECK(promised == 100);

  sut.Grant(10, 64);
  promised = 0;
  for (const auto& credit : sut.Credits()) promised += credit.window_end;
  CHECK(promised == 100);
}

TEST_CASE("A replaced incarnation keeps its credit line but gets no more room") {
  DeliveryLedger sut(kReplay);
  sut.Accept(Batch(1, 0, 1, 0, 1));
  sut.Grant(50, 50);
  sut.Accept(Batch(1, 0, 1, 0, 2));
  sut.Grant(50, 50);

  const auto credits = sut.Credits();
  REQUIRE(credits.size() == 2);
  CHECK(credits[0].actor_incarnation == 2);
  CHECK(credits[0].window_end == 50);
  CHECK(sut.Accept(Batch(1, 5, 1, 0, 1)) == 0);
}

TEST_CASE("What was promised to actors that leave counts no longer, and what they sent is taken") {
  DeliveryLedger sut(kReplay);
  for (std::uint32_t actor = 0; actor < 3; ++actor) sut.Accept(Batch(1, 0, 1, actor));
  sut.Grant(90, 30);

  sut.set_actors(1);
  sut.Grant(90, 80);

  CHECK(sut.wanted_actors() == 1);
  const auto credits = sut.Credits();
  REQUIRE(credits.size() == 3);
  CHECK(credits[0].window_end == 80);  // 90 less what was promised to all would leave it at 30
  CHECK(credits[1].window_end == 30);
  CHECK(credits[2].window_end == 30);
  CHECK(sut.Accept(Batch(1, 30, 1, 2)) == 0);

  sut.set_actors(3);
  sut.Grant(300, 80);
  CHECK(sut.Credits()[2].window_end == 110);
}

}  // namespace
}  // namespace ronda
