#include "common/environments/patrol_environment.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "common/base/error.h"

namespace ronda {
namespace {

/// 0 –10– 1 –20– 2 (m); the shortest closed walk is 60 m.
PatrolGraph Line() {
  GraphData data;
  data.name = "line";
  data.vertex_ids = {"0", "1", "2"};
  data.positions = {{0.0, 0.0}, {10.0, 0.0}, {30.0, 0.0}};
  data.edges = {{0, 1, 10.0}, {1, 2, 20.0}};
  return PatrolGraph(data);
}

/// T_ref = 60 s / robots, T_d = half of it.
PatrolEnvironmentOptions Options(int robots, RewardScheme reward) {
  return {.agents = robots,
          .closed_walk_m = 60.0,
          .horizon = 0.5,
          .episode_length = 4.0,
          .reward = reward};
}

/// Begins an episode in which the robots start at these vertices.
void ResetAt(PatrolEnvironment& environment, const std::vector<int>& vertices) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    environment.Reset(Rng(seed));
    bool wanted = true;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      wanted = wanted && environment.world().target(static_cast<int>(k)) == vertices[k];
    }
    if (wanted) return;
  }
  FAIL("no seed starts there");
}

/// The action that leads to `vertex`: its place among the neighbours of where the robot stands.
int To(const PatrolEnvironment& environment, int vertex) {
  const int here = environment.world().target(environment.decision().agent);
  for (int action = 0; action < environment.world().graph().degree(here); ++action) {
    if (environment.encoder().NextVertex(here, action) == vertex) return action;
  }
  FAIL(here << " has no neighbour " << vertex);
  return -1;
}

void CheckSettled(const StepOutcome& outcome, const std::vector<SettledReward>& expected) {
  REQUIRE(outcome.settled.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(outcome.settled[i].agent == expected[i].agent);
    CHECK(outcome.settled[i].index == expected[i].index);
    CHECK(outcome.settled[i].reward == Approx(expected[i].reward).margin(1e-7));
  }
}

float Value(double value) { return static_cast<float>(value); }

TEST_CASE("Own idleness is settled on arrival") {
  const PatrolGraph graph = Line();
  PatrolEnvironment sut(graph, ShortestPaths(graph), Options(1, RewardScheme::kIdleness));
  ResetAt(sut, {0});

  CheckSettled(sut.Step(To(sut, 1)), {{0, 0, Value(std::exp(-10.0 / 30.0) * 10.0 / 30.0)}});
  CHECK(sut.decision().discount == Approx(std::exp(-10.0 / 30.0)));
  CheckSettled(sut.Step(To(sut, 2)), {{0, 1, Value(std::exp(-20.0 / 30.0) * 30.0 / 30.0)}});
  CHECK(sut.decision().discount == Approx(std::exp(-20.0 / 30.0)));
  CheckSettled(sut.Step(To(sut, 1)), {{0, 2, Value(std::exp(-20.0 / 30.0) * 40.0 / 30.0)}});
}

TEST_CASE("Hindsight settles at the next visit, after 5 T_d as never, and at the end as never") {
  const PatrolGraph graph = Line();
  PatrolEnvironment sut(graph, ShortestPaths(graph), Options(1, RewardScheme::kHindsight));
  ResetAt(sut, {0});
  const auto reward = [](double travel_s, double idleness_s, double gap_s) {
    return Value(std::exp(-travel_s / 30.0) * idleness_s * (1.0 - std::exp(-gap_s / 30.0)) / 30.0);
  };
  const double never_s = 1e9;

  CheckSettled(sut.Step(To(sut, 1)), {});                            // at 1, 10 s
  CheckSettled(sut.Step(To(sut, 2)), {});                            // at 2, 30 s
  CheckSettled(sut.Step(To(sut, 1)), {{0, 0, reward(10, 10, 40)}});  // at 1, 50 s
  CheckSettled(sut.Step(To(sut, 0)), {});                            // at 0, 60 s
  CheckSettled(sut.Step(To(sut, 1)), {{0, 2, reward(20, 40, 20)}});  // at 1, 70 s
  CheckSettled(sut.Step(To(sut, 0)), {{0, 3, reward(10, 60, 20)}});  // at 0, 80 s
  // To and fro between 0 and 1, each visit 20 s after the one before. Vertex 2 waits since 30 s,
  // and 5 T_d are 150 s: still at 180 s it waits.
  std::uint64_t settled = 4;
  for (double at_s = 90.0; at_s <= 180.0; at_s += 10.0) {
    const auto outcome = sut.Step(To(sut, sut.world().target(0) == 0 ? 1 : 0));
    REQUIRE(sut.world().time_s() == at_s);
    CheckSettled(outcome, {{0, settled++, reward(10, 20, 20)}});
  }
  CheckSettled(sut.Step(To(sut, 1)),
               {{0, 1, reward(20, 30, never_s)}, {0, settled++, reward(10, 20, 20)}});  // at 190 s
  for (double at_s = 200.0; at_s < 240.0; at_s += 10.0) {
    const auto outcome = sut.Step(To(sut, sut.world().target(0) == 0 ? 1 : 0));
    REQUIRE(outcome.state == EpisodeState::kRunning);
    CheckSettled(outcome, {{0, settled++, reward(10, 20, 20)}});
  }
  // At 240 s = 4 T_ref the episode is cut, at vertex 0.
  const auto outcome = sut.Step(To(sut, 0));
  CHECK(outcome.state == EpisodeState::kCut);
  CheckSettled(outcome, {{0, settled, reward(10, 20, 20)},
                         {0, settled + 2, reward(10, 20, never_s)},
                         {0, settled + 1, reward(10, 20, never_s)}});
  CHECK(sut.decision().index == settled + 3);  // to bootstrap from
}

TEST_CASE("Hindsight counts the next visit by anyone; robots that arrive together go by index") {
  const PatrolGraph graph = Line();
  PatrolEnvironment sut(graph, ShortestPaths(graph), Options(2, RewardScheme::kHindsight));
  ResetAt(sut, {0, 2});  // T_ref = 30 s, T_d = 15 s

  CheckSettled(sut.Step(To(sut, 1)), {});
  REQUIRE(sut.decision().agent == 1);  // its start
  CheckSettled(sut.Step(To(sut, 1)), {});
  REQUIRE(sut.decision().agent == 0);  // at 1, 10 s
  CheckSettled(sut.Step(To(sut, 0)), {});
  REQUIRE(sut.decision().agent == 0);  // at 0, 20 s, before robot 1 that reaches 1 at 20 s
  REQUIRE(sut.world().time_s() == 20.0);
  const auto outcome = sut.Step(To(sut, 1));
  REQUIRE(sut.decision().agent == 1);

  const double expected =
      std::exp(-10.0 / 15.0) * 10.0 * (1.0 - std::exp(-10.0 / 15.0)) * 2.0 / 30.0;
  CheckSettled(outcome, {{0, 0, Value(expected)}});
}

TEST_CASE("A reward on arrival is of the idleness just before the visit, robot by robot") {
  const PatrolGraph graph = Line();
  PatrolEnvironment sut(graph, ShortestPaths(graph), Options(2, RewardScheme::kCentred));
  ResetAt(sut, {0, 2});  // T_ref = 30 s, T_d = 15 s

  CheckSettled(sut.Step(To(sut, 1)), {});
  // Robot 0 is at 1, 10 s; idleness 10, 10, 10.
  CheckSettled(sut.Step(To(sut, 1)), {{0, 0, 0.0f}});
  // Robot 0 is at 0, 20 s; idleness 20, 10, 20.
  CheckSettled(sut.Step(To(sut, 0)),
               {{0, 1, Value(std::exp(-10.0 / 15.0) * (20.0 - 50.0 / 3.0) * 2.0 / 30.0)}});
  // Robot 1 is at 1, 20 s; idleness 0, 10, 20.
  CheckSettled(sut.Step(To(sut, 1)), {{1, 0, 0.0f}});
}

TEST_CASE("The final average is given once, at the arrival that ends the episode") {
  const PatrolGraph graph = Line();
  PatrolEnvironment sut(graph, ShortestPaths(graph), Options(1, RewardScheme::kFinalAverage));
  ResetAt(sut, {0});
  // To and fro between 0 and 1 until 240 s = 4 T_ref.
  for (std::uint64_t index = 0; index < 23; ++index) {
    const auto outcome = sut.Step(To(sut, sut.world().target(0) == 0 ? 1 : 0));
    REQUIRE(outcome.state == EpisodeState::kRunning);
    CheckSettled(outcome, {{0, index, 0.0f}});
  }

  const auto outcome = sut.Step(To(sut, 0));

  CHECK(outcome.state == EpisodeState::kCut);
  const double mean_s = (20.0 + 10.0 + 240.0) / 3.0;  // just before the visit of 0
  CheckSettled(outcome, {{0, 23, Value(-std::exp(-10.0 / 30.0) * mean_s * 2.0 / 60.0)}});
}

TEST_CASE("An episode starts at random vertices, and idle where asked for") {
  const PatrolGraph graph = Line();
  auto options = Options(1, RewardScheme::kHindsight);
  options.initial_idleness = 2.0;
  PatrolEnvironment sut(graph, ShortestPaths(graph), options);
  std::vector<bool> started_at(3);
  double largest_s = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    sut.Reset(Rng(seed));
    started_at[sut.world().target(0)] = true;
    CHECK(sut.world().idleness_s(sut.world().target(0)) == 0.0);
    largest_s = std::max(largest_s, sut.world().instantaneous_worst_idleness_s());
  }
  CHECK(started_at == std::vector<bool>{true, true, true});
  CHECK(largest_s > 90.0);
  CHECK(largest_s <= 120.0);
}

TEST_CASE("Options out of range are refused with key, rule and value") {
  const PatrolGraph graph = Line();
  const ShortestPaths paths(graph);
  auto options = Options(0, RewardScheme::kIdleness);
  CHECK_THROWS_WITH(PatrolEnvironment(graph, paths, options),
                    "environment.agents: must be ≥ 1, got 0");
  options.agents = 1;
  options.horizon = -2.0;
  CHECK_THROWS_WITH(PatrolEnvironment(graph, paths, options),
                    "environment.horizon: must be > 0, got -2");
  options.horizon = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(PatrolEnvironment(graph, paths, options), InputError);
  options.horizon = 0.5;
  options.reward_n_worst = 0;
  CHECK_THROWS_WITH(PatrolEnvironment(graph, paths, options),
                    "environment.reward_n_worst: must be ≥ 1, got 0");
}

}  // namespace
}  // namespace ronda
