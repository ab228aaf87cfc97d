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

TEST_CASE("The patrol environment conforms where robots fail, join, stay and hear little") {
  const auto observation = GENERATE(from_range(ObservationNames()));
  const auto reward = GENERATE(from_range(RewardNames()));
  CAPTURE(observation, reward);
  Conditions conditions{.speeds_mps = {1.0, 0.5}, .travel_noise = 0.2, .stay_s = 3.0};
  conditions.communication = {.message_loss = 0.5,
                              .message_range_m = 30.0,
                              .message_delay_s = 2.0,
                              .observation_radius_m = 10.0};
  conditions.attrition = {.mean_time_to_failure_s = 60.0, .repair_s = 20.0};
  conditions.priorities = {{"3", 5.0}};
  const PatrolGraph graph = WithPriorities(Map("cumberland"), conditions);
  const ShortestPaths paths(graph);
  PatrolEnvironment sut(graph, paths,
                        {.agents = 6,
                         .conditions = conditions,
                         .closed_walk_m = ClosedWalkOf(graph, paths).length_m,
                         .episode_length = 6.0,
                         .observation = ParseObservationScheme(observation),
                         .reward = ParseRewardScheme(reward)});

  CheckEnvironmentConforms(sut);
}

}  // namespace
}  // namespace ronda
