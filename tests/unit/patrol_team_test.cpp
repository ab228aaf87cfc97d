#include "common/team/patrol_team.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/base/error.h"
#include "common/environments/observation_encoder.h"
#include "common/team/policy_strategy.h"
#include "common/world/graph_file.h"
#include "tests/temporary_folder.h"
#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using Catch::Matchers::Contains;

PatrolGraph Map(const std::string& name) {
  return LoadMap(name, RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
}

/// Weights drawn at random: decisions without sense, but different ones in different situations.
PolicyFile SomePolicy(const PatrolGraph& graph, ObservationScheme scheme) {
  const ObservationEncoder encoder(graph, ShortestPaths(graph), scheme);
  const bool scorer = encoder.features_per_candidate() > 0;
  PolicyFile policy;
  policy.spec = {.kind = scorer ? NetworkSpec::Kind::kCandidateScorer : NetworkSpec::Kind::kMlp,
                 .observation_size = encoder.observation_size(),
                 .num_actions = encoder.num_actions(),
                 .features = encoder.features_per_candidate(),
                 .hidden = {16},
                 .schema = std::string(Schema(scheme))};
  Rng rng(5);
  policy.weights = testing::RandomVector<float>(rng, ParameterCount(policy.spec));
  policy.training.map = graph.name();
  return policy;
}

/// A map, a policy file for it, and a team of three with speeds of their own.
struct Scene {
  explicit Scene(ObservationScheme scheme = ObservationScheme::kCandidates) {
    WritePolicyFile(policy_file, SomePolicy(graph, scheme));
  }

  PatrolGraph graph = Map("cumberland");
  TemporaryFolder folder;
  std::filesystem::path policy_file = folder / "policy.ronda";
  PatrolTeamOptions team{.speeds_mps = {1.0, 0.7, 1.3}, .starts = {0, 17, 30}};
};

std::vector<RobotStart> StartsOf(const PatrolTeamOptions& team) {
  std::vector<RobotStart> starts;
  for (const int vertex : team.starts) starts.push_back({.vertex = vertex, .next = vertex});
  return starts;
}

TEST_CASE(
    "A team that reports what the simulator does decides as its strategy, and knows its AGI") {
  const auto scheme = GENERATE(ObservationScheme::kCandidates, ObservationScheme::kThesis);
  const Scene scene(scheme);
  const ShortestPaths paths(scene.graph);
  const auto strategy =
      LoadPolicyStrategy(scene.policy_file, {.graph = &scene.graph, .paths = &paths});
  PatrolWorld world(scene.graph, {.speeds_mps = scene.team.speeds_mps});
  Rng rng(1);
  world.Reset(StartsOf(scene.team), rng);
  PatrolTeam sut(scene.graph, scene.policy_file, scene.team);

  for (int i = 0; i < 500; ++i) {
    const Arrival arrival = *world.NextArrival(std::numeric_limits<double>::infinity());
    const int expected = strategy->Decide(CompleteBelief(world, arrival.robot), rng);
    REQUIRE(sut.Decide({arrival.robot, arrival.vertex, arrival.time_s}) == expected);
    world.Depart(arrival.robot, expected);
    REQUIRE(sut.world().arrival_s(arrival.robot) == world.arrival_s(arrival.robot));
  }
  CHECK(sut.world().average_graph_idleness_s() == world.average_graph_idleness_s());
}

TEST_CASE(
    "Robots that each have their own object decide as one object does, whatever delays them") {
  const Scene scene;
  PatrolTeam central(scene.graph, scene.policy_file, scene.team);
  std::vector<PatrolTeam> own;
  for (int robot = 0; robot < 3; ++robot) {
    own.emplace_back(scene.graph, scene.policy_file, scene.team);
  }
  std::vector<RobotReport> next = {{0, 0, 0.0}, {1, 17, 0.0}, {2, 30, 0.0}};
  Rng rng(2);
  for (int i = 0; i < 500; ++i) {
    RobotReport& report = *std::min_element(
        next.begin(), next.end(),
        [](const RobotReport& a, const RobotReport& b) { return a.time_s < b.time_s; });
    const int target = central.Decide(report);
    for (int robot = 0; robot < 3; ++robot) {
      if (robot == report.robot) {
        REQUIRE(own[robot].Decide(report) == target);
      } else {
        own[robot].Hear(report, target);
      }
    }
    const double length_m = scene.graph.edge_length_m(report.vertex, target);
    report.time_s += length_m / scene.team.speeds_mps[report.robot] * (0.5 + 2.0 * rng.Uniform());
    report.vertex = target;
  }
}

TEST_CASE("An overdue robot is expected at any moment, and a late report counts as of the newest") {
  const Scene scene;
  PatrolTeam sut(scene.graph, scene.policy_file, scene.team);
  sut.Decide({.robot = 0, .vertex = 0, .time_s = 0.0});
  const int target = sut.Decide({.robot = 1, .vertex = 17, .time_s = 1.0});

  sut.Decide({.robot = 2, .vertex = 30, .time_s = 1000.0});
  CHECK(sut.world().arrival_s(1) == 1000.0);
  CHECK(sut.world().target(1) == target);

  sut.Decide({.robot = 1, .vertex = target, .time_s = 990.0});
  CHECK(sut.world().time_s() == 1000.0);
  CHECK(sut.world().last_visit_s(target) == 1000.0);
}

TEST_CASE("A robot may turn up where it did not announce") {
  const Scene scene;
  PatrolTeam sut(scene.graph, scene.policy_file, scene.team);
  for (int robot = 0; robot < 3; ++robot) {
    sut.Decide({.robot = robot, .vertex = scene.team.starts[robot], .time_s = 0.0});
  }
  const int next = sut.Decide({.robot = 0, .vertex = 39, .time_s = 5.0});
  CHECK(scene.graph.edge_length_m(39, next) > 0.0);
  CHECK(sut.world().last_visit_s(39) == 5.0);
}

TEST_CASE("A report that cannot be is refused with rule and value, and changes nothing") {
  const Scene scene;
  PatrolTeam sut(scene.graph, scene.policy_file, scene.team);
  CHECK_THROWS_WITH(sut.Decide({3, 0, 0.0}), Contains("a robot must be 0 to 2, got 3"));
  CHECK_THROWS_WITH(sut.Decide({-1, 0, 0.0}), Contains("got -1"));
  CHECK_THROWS_WITH(sut.Decide({0, 40, 0.0}), Contains("a vertex must be 0 to 39, got 40"));
  CHECK_THROWS_WITH(sut.Decide({0, 0, std::nan("")}), Contains("finite, got nan"));
  CHECK_THROWS_WITH(sut.Decide({0, 0, -1.0}), Contains("≥ 0 s"));
  CHECK_THROWS_WITH(sut.Hear({0, 0, 0.0}, 0), Contains("no edge from vertex 0 to 0"));
  CHECK_THROWS_AS(sut.Hear({0, 0, 0.0}, 99), InputError);
  CHECK(sut.world().time_s() == 0.0);
  CHECK_NOTHROW(sut.Decide({0, 0, 0.0}));
}

TEST_CASE("A team that cannot be is refused") {
  const Scene scene;
  const auto made = [&](const PatrolTeamOptions& team) {
    PatrolTeam(scene.graph, scene.policy_file, team);
  };
  CHECK_THROWS_WITH(made({.speeds_mps = {1.0, 1.0}, .starts = {0}}), Contains("got 1 for 2"));
  CHECK_THROWS_AS(made({.speeds_mps = {}, .starts = {}}), InputError);
  CHECK_THROWS_AS(made({.speeds_mps = {0.0}, .starts = {0}}), InputError);
  CHECK_THROWS_WITH(made({.speeds_mps = {1.0}, .starts = {40}}), Contains("got 40"));
}

TEST_CASE("A policy whose observation or sizes do not fit is refused by its file's name") {
  const Scene scene;
  const auto refused = [&](const PolicyFile& policy, const std::string& words) {
    WritePolicyFile(scene.policy_file, policy);
    CHECK_THROWS_AS(PatrolTeam(scene.graph, scene.policy_file, scene.team), InputError);
    CHECK_THROWS_WITH(PatrolTeam(scene.graph, scene.policy_file, scene.team),
                      Contains(scene.policy_file.string() + ": ") && Contains(words));
  };
  PolicyFile policy = SomePolicy(scene.graph, ObservationScheme::kCandidates);
  policy.spec.schema = "patrol-of-tomorrow";
  refused(policy, "no observation here has the schema 'patrol-of-tomorrow'");

  policy = SomePolicy(scene.graph, ObservationScheme::kCandidates);
  policy.spec.features = 3;
  policy.spec.observation_size = 3 * policy.spec.num_actions;
  policy.weights.resize(ParameterCount(policy.spec));
  refused(policy, "num_actions × features");

  refused(SomePolicy(Map("grid"), ObservationScheme::kThesis), "trained on grid");
}

}  // namespace
}  // namespace ronda
