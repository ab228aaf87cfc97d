#include "common/rl/delivery_window.h"

#include <catch2/catch.hpp>
#include <map>

#include "common/base/rng.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t kActor = 3;
constexpr std::uint64_t kIncarnation = 77;
constexpr TransitionShape kShape{.observation_size = 2, .num_actions = 2, .extras_size = 1};

DeliveryWindow::TimePoint At(std::int64_t time_ms) {
  return DeliveryWindow::TimePoint(milliseconds(time_ms));
}

DeliveryOptions Options(std::uint32_t batch_size) {
  return {.actor = kActor, .incarnation = kIncarnation, .shape = kShape, .batch_size = batch_size};
}

/// The n-th transition: every array holds its number, so that a mix-up of rows shows.
Transition Numbered(std::uint64_t n) {
  const auto value = static_cast<float>(n);
  return {.observation = {value, -value},
          .action = static_cast<std::int32_t>(n % 2),
          .reward = value,
          .discount = 0.5f,
          .next_observation = {value + 0.5f, 0.0f},
          .next_legal_actions = {1, static_cast<std::uint8_t>(n % 2)},
          .extras = {value * 2},
          .agent = static_cast<std::uint32_t>(n % 5),
          .weights_version = n};
}

ReplayStatus Status(std::uint64_t replay, std::uint64_t stored_through, std::uint64_t window_end) {
  ReplayStatus status;
  status.replay_incarnation = replay;
  status.actors = {{.actor = kActor,
                    .actor_incarnation = kIncarnation,
                    .stored_through = stored_through,
                    .window_end = window_end}};
  return status;
}

ReplayStatus StatusOfNobody(std::uint64_t replay) {
  ReplayStatus status;
  status.replay_incarnation = replay;
  return status;
}

void PushNumbered(DeliveryWindow& sut, std::uint64_t first, std::uint64_t last, std::int64_t ms) {
  for (std::uint64_t n = first; n <= last; ++n) {
    REQUIRE(sut.Push(Numbered(n), At(ms)) == PushResult::kAccepted);
  }
}

/// Sends what there is; returns the (first sequence, count) pairs.
std::vector<std::pair<std::uint64_t, std::uint32_t>> SendAll(DeliveryWindow& sut, std::int64_t ms) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sent;
  while (const TransitionBatch* batch = sut.NextToSend(At(ms))) {
    sent.emplace_back(batch->first_sequence, batch->count);
    sut.MarkSent(At(ms));
  }
  return sent;
}

using Sent = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

/// The least that a replay must do: take what continues what it has, ignore the rest.
class ReferenceReceiver {
 public:
  explicit ReferenceReceiver(std::uint64_t incarnation) : incarnation_(incarnation) {}

  void OnBatch(const TransitionBatch& batch) {
    if (batch.replay_incarnation != incarnation_) return;
    REQUIRE(batch.actor == kActor);
    REQUIRE(batch.actor_incarnation == kIncarnation);
    if (!known_) {
      known_ = true;
      stored_through_ = batch.oldest_unconfirmed - 1;
      first_ = batch.oldest_unconfirmed;
    }
    const std::uint64_t end = batch.first_sequence + batch.count;
    if (batch.first_sequence > stored_through_ + 1) return;
    for (std::uint64_t sequence = stored_through_ + 1; sequence < end; ++sequence) {
      REQUIRE(sequence <= window_end());
      const auto row = static_cast<std::size_t>(sequence - batch.first_sequence);
      const Transition expected = Numbered(sequence);
      REQUIRE(batch.weights_versions[row] == sequence);
      REQUIRE(batch.rewards[row] == expected.reward);
      REQUIRE(batch.observations[2 * row + 1] == expected.observation[1]);
      REQUIRE(batch.next_observations[2 * row] == expected.next_observation[0]);
      REQUIRE(batch.next_legal_actions[2 * row + 1] == expected.next_legal_actions[1]);
      REQUIRE(batch.extras[row] == expected.extras[0]);
      REQUIRE(batch.agents[row] == expected.agent);
      REQUIRE(batch.actions[row] == expected.action);
      stored_through_ = sequence;
    }
  }

  ReplayStatus MakeStatus() const {
    return known_ ? Status(incarnation_, stored_through_, window_end())
                  : StatusOfNobody(incarnation_);
  }
  void set_window(std::uint64_t window) { window_ = window; }
  std::uint64_t window_end() const { return stored_through_ + window_; }
  std::uint64_t first() const { return first_; }
  std::uint64_t stored_through() const { return stored_through_; }
  bool known() const { return known_; }

 private:
  std::uint64_t incarnation_;
  std::uint64_t window_ = 50;
  bool known_ = false;
  std::uint64_t first_ = 0;
  std::uint64_t stored_through_ = 0;
};

/// Drops, doubles, delays and so reorders.
template <typename T>
class FaultyChannel {
 public:
  FaultyChannel(Rng rng, double loss) : rng_(rng), loss_(loss) {}
  void Send(const T& value, std::int64_t now_ms) {
    const int copies = rng_.Uniform() < 0.1 ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
      if (rng_.Uniform() < loss_) continue;
      in_flight_.emplace(now_ms + rng_.Below(40), value);
    }
  }
  std::vector<T> Arrived(std::int64_t now_ms) {
    std::vector<T> arrived;
    while (!in_flight_.empty() && in_flight_.begin()->first <= now_ms) {
      arrived.push_back(std::move(in_flight_.begin()->second));
      in_flight_.erase(in_flight_.begin());
    }
    return arrived;
  }

 private:
  Rng rng_;
  double loss_;
  std::multimap<std::int64_t, T> in_flight_;
};

}  // namespace

TEST_CASE("nothing is accepted or sent before a replay has granted a window") {
  DeliveryWindow sut(Options(4));

  CHECK(sut.Push(Numbered(1), At(0)) == PushResult::kThrottled);
  CHECK(sut.NextToSend(At(0)) == nullptr);
  CHECK_FALSE(sut.replay_known());
}

TEST_CASE("an actor that the replay does not name announces itself every 200 ms") {
  DeliveryWindow sut(Options(4));
  sut.OnStatus(StatusOfNobody(9), At(0));

  const TransitionBatch* first = sut.NextToSend(At(0));
  REQUIRE(first != nullptr);
  CHECK(first->count == 0);
  CHECK(first->replay_incarnation == 9);
  CHECK(first->actor_incarnation == kIncarnation);
  CHECK(first->oldest_unconfirmed == 1);
  sut.MarkSent(At(0));

  CHECK(sut.NextToSend(At(199)) == nullptr);
  CHECK(sut.NextToSend(At(200)) != nullptr);
  CHECK(sut.sent() == 0);
}

TEST_CASE("an actor of the same number but another incarnation is not this one") {
  DeliveryWindow sut(Options(4));
  ReplayStatus status = Status(9, 5, 100);
  status.actors[0].actor_incarnation = kIncarnation + 1;

  sut.OnStatus(status, At(0));

  CHECK_FALSE(sut.named());
  CHECK(sut.Push(Numbered(1), At(0)) == PushResult::kThrottled);
}

TEST_CASE("a batch goes when it is full, when it is 10 ms old, or when it is flushed") {
  DeliveryWindow sut(Options(3));
  sut.OnStatus(Status(9, 0, 100), At(0));

  PushNumbered(sut, 1, 5, 0);
  CHECK(SendAll(sut, 9) == Sent{{1, 3}});
  CHECK(SendAll(sut, 10) == Sent{{4, 2}});
  PushNumbered(sut, 6, 6, 10);
  CHECK(SendAll(sut, 11).empty());
  sut.Flush();
  CHECK(SendAll(sut, 11) == Sent{{6, 1}});
  CHECK(sut.sent() == 6);
}

TEST_CASE("the window's end throttles and its move lets go on") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(9, 0, 3), At(0));

  PushNumbered(sut, 1, 3, 0);
  CHECK(sut.Push(Numbered(4), At(0)) == PushResult::kThrottled);
  SendAll(sut, 20);
  sut.OnStatus(Status(9, 2, 5), At(20));

  PushNumbered(sut, 4, 5, 20);
  CHECK(sut.Push(Numbered(6), At(20)) == PushResult::kThrottled);
  CHECK(sut.confirmed() == 2);
}

TEST_CASE("a batch that could not be sent is offered again") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(9, 0, 10), At(0));
  PushNumbered(sut, 1, 2, 0);

  REQUIRE(sut.NextToSend(At(0)) != nullptr);
  CHECK(sut.sent() == 0);
  CHECK(SendAll(sut, 1) == Sent{{1, 2}});
}

TEST_CASE("one second without progress repeats all that is unconfirmed") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(9, 0, 10), At(0));
  PushNumbered(sut, 1, 6, 0);
  CHECK(SendAll(sut, 0) == Sent{{1, 2}, {3, 2}, {5, 2}});

  sut.OnStatus(Status(9, 2, 12), At(400));
  CHECK(SendAll(sut, 1399).empty());
  CHECK(SendAll(sut, 1400) == Sent{{3, 2}, {5, 2}});
  CHECK(SendAll(sut, 2399).empty());
  CHECK(sut.transitions_repeated() == 4);
  CHECK(sut.sent() == 6);
}

TEST_CASE("idle time is not counted as time without progress") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(9, 0, 10), At(0));
  PushNumbered(sut, 1, 2, 0);
  SendAll(sut, 0);
  sut.OnStatus(Status(9, 2, 12), At(10));

  PushNumbered(sut, 3, 4, 60'000);
  CHECK(SendAll(sut, 60'000) == Sent{{3, 2}});
  CHECK(SendAll(sut, 60'500).empty());
}

TEST_CASE("a new replay is told of the actor first and then gets all that is unconfirmed") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(9, 0, 10), At(0));
  PushNumbered(sut, 1, 6, 0);
  SendAll(sut, 0);
  sut.OnStatus(Status(9, 3, 13), At(5));

  sut.OnStatus(StatusOfNobody(10), At(50));
  const TransitionBatch* announcement = sut.NextToSend(At(50));
  REQUIRE(announcement != nullptr);
  CHECK(announcement->count == 0);
  CHECK(announcement->replay_incarnation == 10);
  CHECK(announcement->oldest_unconfirmed == 4);
  sut.MarkSent(At(50));
  CHECK(sut.Push(Numbered(7), At(50)) == PushResult::kThrottled);

  sut.OnStatus(Status(10, 3, 13), At(60));
  CHECK(SendAll(sut, 60) == Sent{{3, 2}, {5, 2}});
}

TEST_CASE("a late word of a dead replay confirms nothing") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(9, 0, 10), At(0));
  PushNumbered(sut, 1, 4, 0);
  SendAll(sut, 0);
  sut.OnStatus(Status(10, 0, 10), At(50));

  sut.OnStatus(Status(9, 4, 14), At(60));

  CHECK(sut.confirmed() == 0);
  CHECK(sut.replay_incarnation() == 10);
}

TEST_CASE("a replay taken for dead is heard again when its successor stays silent") {
  DeliveryWindow sut(Options(2));
  sut.OnStatus(Status(10, 0, 10), At(0));
  sut.OnStatus(Status(9, 0, 10), At(10));

  sut.OnStatus(Status(10, 0, 10), At(5009));
  CHECK(sut.replay_incarnation() == 9);
  sut.OnStatus(Status(10, 0, 10), At(5010));
  CHECK(sut.replay_incarnation() == 10);
}

TEST_CASE("a smaller window of a new replay splits a batch instead of holding it") {
  DeliveryWindow sut(Options(4));
  sut.OnStatus(Status(9, 0, 8), At(0));
  PushNumbered(sut, 1, 8, 0);

  sut.OnStatus(Status(10, 0, 6), At(1));
  CHECK(SendAll(sut, 1) == Sent{{1, 4}, {5, 2}});
  sut.OnStatus(Status(10, 6, 12), At(2));
  const TransitionBatch* rest = sut.NextToSend(At(2));
  REQUIRE(rest != nullptr);
  CHECK(rest->first_sequence == 7);
  CHECK(rest->weights_versions == std::vector<std::uint64_t>{7, 8});
  CHECK(rest->observations == std::vector<float>{7, -7, 8, -8});
}

TEST_CASE("a confirmation of what was never sent is not believed") {
  DeliveryWindow sut(Options(4));
  sut.OnStatus(Status(9, 0, 8), At(0));
  PushNumbered(sut, 1, 2, 0);

  sut.OnStatus(Status(9, 2, 500), At(1));

  CHECK(sut.confirmed() == 0);
  CHECK(SendAll(sut, 20) == Sent{{1, 2}});
}

TEST_CASE(
    "a link that loses, doubles and reorders, and replays that die, lose and double nothing") {
  constexpr std::uint64_t kTransitions = 300;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    Rng rng = SplitSeed(seed, 0);
    const double loss = 0.4 * rng.Uniform();
    DeliveryWindow sut(Options(1 + rng.Below(20)));
    FaultyChannel<TransitionBatch> to_replay(SplitSeed(seed, 1), loss);
    FaultyChannel<ReplayStatus> to_actor(SplitSeed(seed, 2), loss);
    std::uint64_t incarnation = 1000;
    ReferenceReceiver replay(incarnation);
    std::uint64_t covered_through = 0;  // stored by the replays of before and by this one
    std::int64_t now_ms = 0;
    while (!(sut.accepted() == kTransitions && sut.all_confirmed())) {
      REQUIRE(now_ms < 400'000);
      for (int burst = 0; burst < 3 && sut.accepted() < kTransitions; ++burst) {
        if (sut.Push(Numbered(sut.accepted() + 1), At(now_ms)) != PushResult::kAccepted) break;
      }
      while (const TransitionBatch* batch = sut.NextToSend(At(now_ms))) {
        to_replay.Send(*batch, now_ms);
        sut.MarkSent(At(now_ms));
      }
      for (const TransitionBatch& batch : to_replay.Arrived(now_ms)) replay.OnBatch(batch);
      if (replay.known()) {
        REQUIRE(replay.first() <= covered_through + 1);  // a gap would be lost for good
        covered_through = std::max(covered_through, replay.stored_through());
      }
      REQUIRE(sut.confirmed() <= covered_through);
      if (rng.Uniform() < 0.002) {
        replay = ReferenceReceiver(++incarnation);
        replay.set_window(10 + rng.Below(60));
      }
      if (now_ms % 20 == 0) to_actor.Send(replay.MakeStatus(), now_ms);
      for (const ReplayStatus& status : to_actor.Arrived(now_ms)) sut.OnStatus(status, At(now_ms));
      now_ms += 4;
    }
    REQUIRE(covered_through == kTransitions);
  }
}

}  // namespace ronda
