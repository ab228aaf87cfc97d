// The patrol environment keeps the rules of environments, for each observation, reward and noise,
// on several maps and team sizes (more robots than vertices too).
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "common/environments/patrol_environment.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"
#include "tests/conformance/environment_conformance.h"

namespace ronda {
namespace {

struct Case {
  std::string map;
  int agents;
  double episode_length;  // T_ref
};

PatrolGraph Map(const std::string& name) {
  return LoadMap(name, RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
}

TEST_CASE("The patrol environment conforms, whatever it observes, rewards and suffers") {
  const auto where =
      GENERATE(Case{"4nodes", 1, 8.0}, Case{"4nodes", 2, 8.0}, Case{"4nodes", 7, 20.0},
               Case{"grid", 3, 3.0}, Case{"cumberland", 10, 3.0}, Case{"cumberland", 45, 6.0});
  const auto observation = GENERATE(from_range(ObservationNames()));
  const auto reward = GENERATE(from_range(RewardNames()));
  const auto noise = GENERATE(0.0, 0.3);
  CAPTURE(where.map, where.agents, observation, reward, noise);
  const PatrolGraph graph = Map(where.map);
  const ShortestPaths paths(graph);
  PatrolEnvironment sut(graph, paths,
                        {.agents = where.agents,
                         .conditions = {.travel_noise = noise},
                         .closed_walk_m = ClosedWalkOf(graph, paths).length_m,
                         .episode_length = where.episode_length,
                         .initial_idleness = where.agents == 2 ? 1.5 : 0.0,
                         .observation = ParseObservationScheme(observation),
                         .reward = ParseRewardScheme(reward)});

  CheckEnvironmentConforms(sut);
}

}  // namespace
}  // namespace ronda
