// The patrol environment's episode in patrol_episode.txt: two robots on four vertices.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <vector>

#include "common/environments/patrol_environment.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"
#include "tests/golden/episode_text.h"

namespace ronda::testing {
namespace {

constexpr const char* kPreface =
    "# Two robots at 1 m/s on the map 4nodes, hindsight reward, T_ref 65 s, T_d 0.3 T_ref. Where "
    "an\n"
    "# arrival stands, 'idle' is the time since anyone was there; 'sees k:' has the 26 features "
    "of\n"
    "# the k-th neighbour, in the order of common/environments/candidate_encoder.h.\n";

constexpr std::uint64_t kSeed = 1;

/// Keeps books of its own about who was where when, so the world is not its own witness.
class Place {
 public:
  explicit Place(const PatrolEnvironment& environment)
      : environment_(environment),
        last_visits_s_(static_cast<std::size_t>(environment.world().graph().vertex_count())) {}

  std::string operator()(const Decision& decision) {
    const PatrolWorld& world = environment_.world();
    const int vertex = world.target(decision.agent);
    const double idle_s = world.time_s() - last_visits_s_[vertex];
    last_visits_s_[vertex] = world.time_s();
    return fmt::format("{} s, robot {} at {}, idle {} s", Rounded(world.time_s()), decision.agent,
                       world.graph().vertex_id(vertex), Rounded(idle_s));
  }

 private:
  const PatrolEnvironment& environment_;
  std::vector<double> last_visits_s_;  // (V)
};

TEST_CASE("The patrol environment's kept episode is as it was") {
  const PatrolGraph graph =
      LoadMap("4nodes", RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  PatrolEnvironment sut(graph, paths,
                        {.agents = 2,
                         .closed_walk_m = ClosedWalkOf(graph, paths).length_m,
                         .horizon = 0.3,
                         .episode_length = 5.0,
                         .reward = RewardScheme::kHindsight});

  const std::string text = EpisodeText(
      sut, {.seed = kSeed, .row = sut.encoder().features_per_candidate(), .place = Place(sut)});

  CheckKeptEpisode(kPreface + text, "patrol_episode.txt");
}

TEST_CASE("A number near the middle of two roundings is not kept") {
  CHECK(Rounded(1.0 / 3.0) == "0.333");
  CHECK(Rounded(-1e-9) == "0.000");
  CHECK(Rounded(-2.0 / 3.0) == "-0.667");
}

}  // namespace
}  // namespace ronda::testing
