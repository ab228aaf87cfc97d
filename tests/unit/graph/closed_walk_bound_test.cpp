#include "common/world/closed_walk_bound.h"

#include <catch2/catch.hpp>

#include "common/world/closed_walk.h"
#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

TEST_CASE("the lower value of a shipped map's closed walk is its length, within a millionth") {
  const std::string name = GENERATE("4nodes", "cumberland", "grid", "milwaukee");
  CAPTURE(name);
  const PatrolGraph graph = testing::ShippedMap(name);

  const ClosedWalkBound sut = ClosedWalkLowerBound(graph, ShortestPaths(graph));

  CHECK(sut.length_m <= graph.shortest_closed_walk()->length_m * (1.0 + 1e-9));
  CHECK(sut.length_m >= graph.shortest_closed_walk()->length_m * (1.0 - 1e-6));
}

TEST_CASE("the lower value lies at most 3 % below the walk that is found, and never above") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  const PatrolGraph graph(testing::RandomGraphData(30, 20, seed));
  const ShortestPaths paths(graph);
  const double found_m = FindShortestClosedWalk(graph, paths, seed).length_m;

  const ClosedWalkBound sut = ClosedWalkLowerBound(graph, paths);

  CHECK(sut.length_m <= found_m * (1.0 + 1e-9));
  CHECK(sut.length_m >= found_m * 0.97);
}

TEST_CASE("1-trees give a bound however early the search ends") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  const int iterations = GENERATE(1, 2, 3, 10, 100);
  CAPTURE(seed, iterations);
  const PatrolGraph graph(testing::RandomGraphData(30, 20, seed));
  const ShortestPaths paths(graph);

  const double sut_m = OneTreeBound_m(paths, iterations);

  CHECK(sut_m > 0.0);
  CHECK(sut_m <= FindShortestClosedWalk(graph, paths, seed).length_m * (1.0 + 1e-9));
}

TEST_CASE("a walk on a tree takes each edge twice, and so does its lower value") {
  const int vertices = GENERATE(2, 3, 4, 20);
  CAPTURE(vertices);
  const PatrolGraph tree(testing::RandomGraphData(vertices, 0, 5));
  const double twice_m = 2.0 * tree.mean_edge_length_m() * tree.edge_count();

  const ClosedWalkBound sut = ClosedWalkLowerBound(tree, ShortestPaths(tree));

  CHECK(sut.length_m == Approx(twice_m).epsilon(1e-3));
  CHECK(sut.length_m <= twice_m * (1.0 + 1e-9));
}

TEST_CASE("priorities do not change how long a closed walk is") {
  GraphData data = testing::RandomGraphData(10, 5, 4);
  const PatrolGraph plain(data);
  data.priorities.assign(10, 1.0);
  data.priorities[3] = 100.0;
  const PatrolGraph weighted(data);
  CHECK(ClosedWalkLowerBound(weighted, ShortestPaths(weighted)).length_m ==
        Approx(ClosedWalkLowerBound(plain, ShortestPaths(plain)).length_m).epsilon(1e-6));
}

}  // namespace
}  // namespace ronda
