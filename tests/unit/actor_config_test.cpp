#include "actor/actor_config.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "actor/actor.h"
#include "common/base/error.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"

namespace ronda {
namespace {

ActorConfig Read(const std::vector<std::string>& settings) {
  Config config = Config::FromString("run.agents = 3", "config.toml");
  for (const std::string& setting : settings) config.Set(setting);
  const RunConfig run = ReadRunConfig(config);
  const ActorConfig actor = ReadActorConfig(config, run);
  config.RejectUnknown();
  return actor;
}

/// Accepts everything.
struct MemorySink final : TransitionSink {
  PushResult Push(const Transition& transition) override {
    taken.push_back(transition);
    return PushResult::kAccepted;
  }
  void Poll() override {}
  void Wait(std::chrono::milliseconds) override {}
  std::vector<Transition> taken;
};

struct NoWeights final : WeightSource {
  const WeightSnapshot* Newest() override { return nullptr; }
};

/// Never asked: without weights the actor acts at random.
struct NoPolicy final : Policy {
  int Act(std::span<const float>, std::span<const std::uint8_t>) override { return -1; }
  LoadResult Load(const WeightSnapshot&) override { return LoadResult::kOtherArchitecture; }
  std::uint64_t architecture_hash() const override { return 0; }
};

TEST_CASE("Every reward with every observation starts by its name and gives transitions") {
  const auto reward = GENERATE(from_range(RewardNames()));
  const auto observation = GENERATE(from_range(ObservationNames()));
  CAPTURE(reward, observation);
  const PatrolGraph graph =
      LoadMap("4nodes", RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  ActorConfig config = Read({"reward=" + reward, "observation=" + observation});
  config.environment.closed_walk_m = ClosedWalkOf(graph, paths).length_m;
  PatrolEnvironment environment(graph, paths, config.environment);
  MemorySink sink;
  NoWeights weights;
  NoPolicy policy;
  Actor sut(environment, policy, sink, weights, {});

  while (sut.counters().episodes < 2) REQUIRE(sut.Step() == 1);

  REQUIRE(sink.taken.size() > 100);
  CHECK(std::any_of(sink.taken.begin(), sink.taken.end(),
                    [](const Transition& transition) { return transition.reward != 0.0f; }));
  CHECK(Name(config.environment.reward) == reward);
  CHECK(Name(config.environment.observation.scheme) == observation);
}

TEST_CASE("What goes with a reward and an observation is read from its own key") {
  const ActorConfig config = Read(
      {"observation=normalised", "observation_alpha=1e5", "reward=n-worst", "reward_n_worst=7"});
  CHECK(config.environment.observation.alpha == 1e5);
  CHECK(config.environment.reward_n_worst == 7);
}

TEST_CASE("Unknown rewards, observations and keys are refused with the names that there are") {
  CHECK_THROWS_WITH(Read({"reward=fame"}),
                    Catch::Contains("reward: must be one of idleness, ranking, normalised") &&
                        Catch::Contains("final-average, hindsight") &&
                        Catch::Contains(", got \"fame\""));
  CHECK_THROWS_WITH(Read({"observation=pixels"}),
                    Catch::Contains("observation: must be one of candidates, thesis, sorted") &&
                        Catch::Contains("matrix, got \"pixels\""));
  CHECK_THROWS_WITH(Read({"rewad=ranking"}), Catch::Contains("did you mean reward?"));
  CHECK_THROWS_WITH(Read({"environment.reward=ranking"}), Catch::Contains("did you mean reward?"));
  CHECK_THROWS_WITH(Read({"reward_n_worst=0"}), Catch::Contains("must be 1 to 10000, got 0"));
}

}  // namespace
}  // namespace ronda
