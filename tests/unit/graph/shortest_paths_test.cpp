#include "common/world/shortest_paths.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

/// Floyd (1962) and Warshall (1962).
std::vector<std::vector<double>> FloydWarshall(const PatrolGraph& graph) {
  const int count = graph.vertex_count();
  std::vector<std::vector<double>> d_m(
      count, std::vector<double>(count, std::numeric_limits<double>::infinity()));
  for (int v = 0; v < count; ++v) d_m[v][v] = 0.0;
  for (const Edge& edge : graph.edges()) {
    d_m[edge.source][edge.target] = d_m[edge.target][edge.source] = edge.length_m;
  }
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) d_m[i][j] = std::min(d_m[i][j], d_m[i][k] + d_m[k][j]);
    }
  }
  return d_m;
}

TEST_CASE("distances are those of Floyd-Warshall, and the same in both directions") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  const PatrolGraph graph(testing::RandomGraphData(30, 25, seed));

  const ShortestPaths sut(graph);

  const auto expected_m = FloydWarshall(graph);
  for (int from = 0; from < graph.vertex_count(); ++from) {
    for (int to = 0; to < graph.vertex_count(); ++to) {
      REQUIRE(sut.distance_m(from, to) == Approx(expected_m[from][to]).epsilon(1e-12));
      REQUIRE(sut.distance_m(from, to) == sut.distance_m(to, from));
      REQUIRE(sut.distances_from(from)[to] == sut.distance_m(from, to));
    }
  }
}

TEST_CASE("following the next hops walks the distance") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  CAPTURE(seed);
  const PatrolGraph graph(testing::RandomGraphData(30, 25, seed));
  const ShortestPaths sut(graph);

  for (int from = 0; from < graph.vertex_count(); ++from) {
    for (int to = 0; to < graph.vertex_count(); ++to) {
      double walked_m = 0.0;
      int hops = 0;
      for (int at = from; at != to; ++hops) {
        REQUIRE(hops < graph.vertex_count());
        const int next = sut.next_hop(at, to);
        walked_m += graph.edge_length_m(at, next);
        at = next;
      }
      REQUIRE(walked_m == Approx(sut.distance_m(from, to)).epsilon(1e-9));
    }
  }
  CHECK(sut.next_hop(7, 7) == 7);
}

TEST_CASE("among equal paths the next hop is the neighbour with the lowest index") {
  const PatrolGraph graph = testing::ShippedMap("grid");  // 5 × 5, vertices by column
  const ShortestPaths sut(graph);

  CHECK(sut.next_hop(0, 24) == 1);
  CHECK(sut.next_hop(24, 0) == 19);
  CHECK(sut.next_hop(12, 0) == 7);
}

TEST_CASE("next hops end even where an edge vanishes in the rounding of the distances") {
  const PatrolGraph graph({.vertex_ids = {"0", "1", "2", "3"},
                           .positions = {{0, 0}, {1, 0}, {2, 0}, {3, 0}},
                           .edges = {{0, 1, 1e-300}, {1, 2, 1e-300}, {2, 3, 1e12}}});
  const ShortestPaths sut(graph);

  CHECK(sut.next_hop(0, 3) == 1);
  CHECK(sut.next_hop(1, 3) == 2);
  CHECK(sut.next_hop(3, 0) == 2);
}

}  // namespace
}  // namespace ronda
