#include "actor/actor.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <set>
#include <stop_token>
#include <thread>
#include <vector>

#include "common/environments/patrol_environment.h"
#include "common/world/graph_file.h"

namespace ronda {
namespace {

/// Accepts, or throttles with some probability; keeps what it accepted.
class MemorySink final : public TransitionSink {
 public:
  MemorySink(double throttle, std::uint64_t seed) : throttle_(throttle), rng_(seed) {}
  PushResult Push(const Transition& transition) override {
    if (taken.size() >= close_after) return PushResult::kClosed;
    if (rng_.Uniform() < throttle_) return PushResult::kThrottled;
    taken.push_back(transition);
    return PushResult::kAccepted;
  }
  void Poll() override { ++polls; }
  void Wait(std::chrono::milliseconds) override {}

  std::vector<Transition> taken;
  std::size_t close_after = static_cast<std::size_t>(-1);
  int polls = 0;

 private:
  double throttle_;
  Rng rng_;
};

/// Gives each snapshot once.
class MemoryWeights final : public WeightSource {
 public:
  const WeightSnapshot* Newest() override { return fresh ? (fresh = false, &snapshot) : nullptr; }
  void Publish(std::uint64_t version, std::uint64_t architecture_hash = 1) {
    snapshot.version = version;
    snapshot.architecture_hash = architecture_hash;
    fresh = true;
  }
  WeightSnapshot snapshot;
  bool fresh = false;
};

/// Takes the first legal action, and remembers how often it was asked.
class FirstLegal final : public Policy {
 public:
  int Act(std::span<const float>, std::span<const std::uint8_t> legal_actions) override {
    ++asked;
    return static_cast<int>(std::find(legal_actions.begin(), legal_actions.end(), 1) -
                            legal_actions.begin());
  }
  LoadResult Load(const WeightSnapshot& snapshot) override {
    return snapshot.architecture_hash == 1 ? LoadResult::kLoaded : LoadResult::kOtherArchitecture;
  }
  std::uint64_t architecture_hash() const override { return 1; }
  int asked = 0;
};

struct Setup {
  explicit Setup(double throttle = 0.0, ActorOptions options = {}, std::uint64_t throttle_seed = 1)
      : graph(LoadMap("4nodes", RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr)),
        environment(graph, ShortestPaths(graph),
                    {.agents = 3, .closed_walk_m = 130.0, .episode_length = 10.0}),
        sink(throttle, throttle_seed),
        sut(environment, policy, sink, weights, options) {}

  void Decide(std::uint64_t decisions) {
    while (sut.counters().decisions < decisions) sut.Step();
  }

  PatrolGraph graph;
  PatrolEnvironment environment;
  FirstLegal policy;
  MemorySink sink;
  MemoryWeights weights;
  Actor sut;
};

ActorOptions Greedy() { return {.exploration = {.start = 0.0, .end = 0.0}}; }

bool Same(const Transition& a, const Transition& b) {
  return a.observation == b.observation && a.action == b.action && a.reward == b.reward &&
         a.discount == b.discount && a.next_observation == b.next_observation &&
         a.next_legal_actions == b.next_legal_actions && a.agent == b.agent &&
         a.weights_version == b.weights_version;
}

TEST_CASE("A sink that throttles at random loses and doubles nothing, and changes nothing") {
  const int n = GENERATE(1, 3);
  Setup free(0.0, {.n_step = n});
  Setup throttled(0.7, {.n_step = n}, 29);

  free.Decide(2000);
  throttled.Decide(2000);
  while (throttled.sink.taken.size() < free.sink.taken.size()) {
    const auto before = throttled.sut.counters().decisions;
    throttled.sut.Step();
    if (throttled.sut.counters().decisions > before) break;  // its outbox is empty
  }

  REQUIRE(throttled.sut.counters().throttled > 1000);
  REQUIRE(throttled.sut.counters().episodes >= 2);
  REQUIRE(free.sink.taken.size() > 1500);
  REQUIRE(throttled.sink.taken.size() >= free.sink.taken.size());
  for (std::size_t i = 0; i < free.sink.taken.size(); ++i) {
    REQUIRE(Same(throttled.sink.taken[i], free.sink.taken[i]));
  }
  CHECK(throttled.sut.counters().transitions == throttled.sink.taken.size());
}

TEST_CASE(
    "Every decision becomes one transition, is dropped at an episode's end, or is under way") {
  Setup setup;
  while (setup.sut.counters().episodes < 5) setup.sut.Step();

  const ActorCounters counters = setup.sut.counters();

  CHECK(counters.transitions + counters.dropped == counters.decisions);
  CHECK(counters.dropped == 5 * 2);  // the two robots that were under way when it was cut
}

TEST_CASE("While throttled the actor makes no decision, and polls the sink") {
  Setup setup(1.0);
  while (setup.sut.Step() == 1) {
  }
  const auto decisions = setup.sut.counters().decisions;
  const int polls = setup.sink.polls;

  for (int i = 0; i < 10; ++i) CHECK(setup.sut.Step() == 0);

  CHECK(setup.sut.counters().decisions == decisions);
  CHECK(setup.sink.polls == polls + 10);
  CHECK(setup.sink.taken.empty());
}

TEST_CASE("Without weights it acts at random; with them greedily, and stamps their version") {
  Setup setup(0.0, Greedy());
  setup.Decide(300);
  CHECK(setup.policy.asked == 0);
  std::set<int> actions;
  for (const Transition& transition : setup.sink.taken) {
    CHECK(transition.weights_version == 0);
    actions.insert(transition.action);
  }
  CHECK(actions.size() > 1);
  const std::size_t before = setup.sink.taken.size();

  setup.weights.Publish(7);
  setup.Decide(600);

  CHECK(setup.policy.asked == 300);
  CHECK(setup.sut.counters().weights_version == 7);
  const auto last = setup.sink.taken.back();
  CHECK(setup.sink.taken.size() > before);
  CHECK(last.weights_version == 7);
  CHECK(last.action == 0);
}

TEST_CASE("Weights of another architecture are refused and the old ones stay") {
  Setup setup(0.0, Greedy());
  setup.weights.Publish(3);
  setup.Decide(1);
  setup.weights.Publish(4, 999);

  setup.Decide(2);

  CHECK(setup.sut.counters().weights_refused == 1);
  CHECK(setup.sut.counters().weights_version == 3);
  CHECK(setup.policy.asked == 2);
}

TEST_CASE("It explores as often as the schedule says at this progress") {
  Setup setup(0.0, {.exploration = {.start = 1.0, .end = 0.2, .share = 0.5}});
  setup.weights.Publish(1);
  setup.Decide(100);
  CHECK(setup.policy.asked == 0);

  setup.sut.set_progress(0.9);
  setup.Decide(10'100);

  // 10 000 decisions, each greedy with 0.8: standard deviation 40, five of them allowed (false
  // alarm 6e-7).
  CHECK(setup.policy.asked == Approx(8000.0).margin(200.0));
}

TEST_CASE("The same seed gives the same transitions, another actor others") {
  Setup first(0.0, {.seed = 5, .index = 1, .actors = 2});
  Setup same(0.0, {.seed = 5, .index = 1, .actors = 2});
  Setup other(0.0, {.seed = 5, .index = 0, .actors = 2});
  first.Decide(200);
  same.Decide(200);
  other.Decide(200);

  REQUIRE(first.sink.taken.size() == same.sink.taken.size());
  REQUIRE(!first.sink.taken.empty());
  CHECK(
      std::equal(first.sink.taken.begin(), first.sink.taken.end(), same.sink.taken.begin(), Same));
  CHECK_FALSE(std::equal(first.sink.taken.begin(), first.sink.taken.end(), other.sink.taken.begin(),
                         other.sink.taken.end(), Same));
}

TEST_CASE("A sink that closes ends the actor's steps") {
  Setup setup;
  setup.sink.close_after = 40;

  int steps = 0;
  while (setup.sut.Step() > 0) REQUIRE(++steps < 10'000);

  CHECK(setup.sut.closed());
  CHECK(setup.sut.Step() == 0);
  CHECK(setup.sink.taken.size() == 40);
}

}  // namespace
}  // namespace ronda
