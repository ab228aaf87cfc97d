// The episodes of docs/strategies.md, traced by hand there.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "common/world/closed_walk.h"
#include "common/world/strategies/strategy.h"
#include "tests/unit/graphs_by_hand.h"
#include "tests/unit/played_team.h"

namespace ronda {
namespace {

using testing::GraphOf;
using testing::PlayedTeam;

/// A seed with which the robots start on these vertices: random starts are all different.
std::uint64_t SeedOf(const PatrolGraph& graph, const std::vector<int>& starts) {
  for (std::uint64_t seed = 0;; ++seed) {
    Rng rng = SplitSeed(seed, 0);
    const auto drawn = PatrolWorld::RandomStarts(graph, static_cast<int>(starts.size()), rng);
    if (std::ranges::equal(drawn, starts, {}, &RobotStart::vertex)) return seed;
  }
}

/// A team of one strategy, from given vertices at 1 m/s.
struct Episode {
  PatrolGraph graph;
  ShortestPaths paths;
  ClosedWalk walk;
  std::unique_ptr<Strategy> strategy;
  PlayedTeam team;

  Episode(const std::string& name, PatrolGraph map, const std::vector<int>& starts)
      : graph(std::move(map)),
        paths(graph),
        walk(ClosedWalkOf(graph, paths)),
        strategy(MakeStrategy(name, {.graph = &graph, .paths = &paths, .closed_walk = &walk})),
        team(graph, *strategy, std::vector<double>(starts.size(), 1.0), SeedOf(graph, starts)) {}

  /// Where the robots went, in the order of their decisions.
  std::vector<int> Play(int decisions) {
    std::vector<int> went;
    for (int i = 0; i < decisions; ++i) went.push_back(team.DecideNext());
    return went;
  }
};

/// The path 0 – 1 – 2 – 3 – 4, each edge 1 m, drawn on a line.
PatrolGraph Line() {
  GraphData data;
  data.name = "line";
  for (int v = 0; v < 5; ++v) {
    data.vertex_ids.push_back(std::to_string(v));
    data.positions.push_back({.x_m = static_cast<double>(v), .y_m = 0.0});
    if (v > 0) data.edges.push_back({v - 1, v, 1.0});
  }
  return PatrolGraph(std::move(data));
}

TEST_CASE("HCR: the traced episode") {
  // Leaves 2, 3 and 6 m from 0.
  Episode sut("hcr", GraphOf(4, {{0, 1, 2.0}, {0, 2, 3.0}, {0, 3, 6.0}}), {0});
  CHECK(sut.Play(8) == std::vector<int>{1, 0, 2, 0, 1, 0, 2, 0});
}

TEST_CASE("HPCC: the traced episode") {
  Episode sut("hpcc", GraphOf(4, {{0, 1, 1.0}, {1, 3, 4.0}, {0, 2, 3.0}, {2, 3, 3.0}}), {0});
  CHECK(sut.Play(8) == std::vector<int>{1, 0, 2, 3, 1, 0, 2, 3});
}

TEST_CASE("HPCC goes to a far vertex by the idle way, and keeps to it") {
  // The square 0 – 1 – 3 – 2 – 0, each edge 1 m: 3 was seen 12 s ago, 2 5 s ago and 1 1 s ago.
  Episode sut("hpcc", GraphOf(4, {{0, 1, 1.0}, {0, 2, 1.0}, {1, 3, 1.0}, {2, 3, 1.0}}), {3});
  for (const int next : {2, 0, 2, 0, 2, 0, 2, 0, 1, 0, 1, 0}) sut.team.DecideThenGo(next);
  CHECK(sut.Play(2) == std::vector<int>{2, 3});
}

TEST_CASE("GBS: the traced episode") {
  // Leaves 1, 3 and 9 m from 0; the robot comes to 0 at 2 s.
  Episode sut("gbs", GraphOf(4, {{0, 1, 1.0}, {0, 2, 3.0}, {0, 3, 9.0}}), {0});
  sut.team.StartFrom({{.vertex = 3, .next = 0, .remaining_m = 2.0}});
  CHECK(sut.Play(12) == std::vector<int>{1, 0, 2, 0, 1, 0, 2, 0, 1, 0, 3, 0});
}

TEST_CASE("CBLS: the traced episode, whose last choice is learnt") {
  Episode sut("cbls", GraphOf(4, {{0, 1, 1.0}, {0, 2, 2.0}, {0, 3, 3.0}}), {0});
  CHECK(sut.Play(10) == std::vector<int>{1, 0, 2, 0, 3, 0, 1, 0, 3, 0});
}

TEST_CASE("DTAG: the traced episode") {
  Episode sut("dtag", Line(), {0, 4});
  CHECK(sut.Play(10) == std::vector<int>{1, 3, 2, 4, 1, 3, 0, 4, 1, 3});
}

TEST_CASE("DTAP: the traced episode") {
  Episode sut("dtap", Line(), {0, 4});
  CHECK(sut.Play(6) == std::vector<int>{1, 3, 2, 2, 3, 1});
}

TEST_CASE("AHPA: the traced episode, and a new plan when a robot is lost") {
  Episode sut("ahpa", Line(), {0, 4});
  const std::vector<RobotChange> loss{{.time_s = 2.5, .robot = 1}};
  sut.team.world.Schedule(loss);
  CHECK(sut.Play(6) == std::vector<int>{1, 3, 2, 4, 1, 3});
  // Robot 0 is at 1 when it knows of the loss, at 3 s; all vertices are its cell then.
  std::vector<int> visits(5, 0);
  while (sut.team.world.time_s() < 3.0 + 8.0) ++visits[sut.team.DecideNext()];
  for (const int count : visits) CHECK(count >= 1);
}

TEST_CASE("AHPA: robots of one place share its cell; a cell of one vertex is left") {
  // Cells {0, 1}, {2, 3} and {4}. Robot 0 is lost when the others are on the way to 3.
  Episode sut("ahpa", Line(), {0, 2, 4});
  const std::vector<RobotChange> loss{{.time_s = 0.5, .robot = 0}};
  sut.team.world.Schedule(loss);
  CHECK(sut.Play(3) == std::vector<int>{1, 3, 3});
  // The tour of both: 3 4 0 1 2. Robot 2 begins two stops further on, at 0.
  CHECK(sut.Play(8) == std::vector<int>{4, 2, 3, 1, 2, 0, 1, 1});
}

}  // namespace
}  // namespace ronda
