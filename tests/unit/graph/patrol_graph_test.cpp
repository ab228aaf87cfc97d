#include "common/world/patrol_graph.h"

#include <catch2/catch.hpp>
#include <limits>

#include "common/base/error.h"
#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

using Catch::Matchers::Equals;

/// A path 0 - 1 - 2 of 3 m and 4 m, its edges in no order.
GraphData Path() {
  return {.name = "path",
          .vertex_ids = {"a", "b", "c"},
          .positions = {{0, 0}, {3, 0}, {3, 4}},
          .edges = {{2, 1, 4.0}, {0, 1, 3.0}}};
}

TEST_CASE("neighbours stand in ascending order with their lengths beside them") {
  const PatrolGraph sut(Path());

  CHECK(std::vector<int>(sut.neighbours(1).begin(), sut.neighbours(1).end()) ==
        std::vector<int>{0, 2});
  CHECK(sut.lengths_m(1)[0] == 3.0);
  CHECK(sut.lengths_m(1)[1] == 4.0);
  CHECK(sut.degree(0) == 1);
  CHECK(sut.max_degree() == 2);
  CHECK(sut.first_arc(2) == 3);
  CHECK(sut.mean_edge_length_m() == 3.5);
}

TEST_CASE("weights are the priorities over their mean, 1 where all are alike") {
  GraphData data = Path();
  CHECK(PatrolGraph(data).weights()[1] == 1.0);
  CHECK(PatrolGraph(data).unweighted());

  data.priorities = {7.0, 7.0, 7.0};
  CHECK(PatrolGraph(data).unweighted());

  data.priorities = {1.0, 4.0, 1.0};
  const PatrolGraph sut(data);
  CHECK(std::vector<double>(sut.weights().begin(), sut.weights().end()) ==
        std::vector<double>{0.5, 2.0, 0.5});
  CHECK_FALSE(sut.unweighted());
}

TEST_CASE("a priority is a number that can be reckoned with") {
  for (const double bad : {0.0, -1.0, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
    GraphData data = Path();
    data.priorities = {1.0, bad, 1.0};
    CHECK_THROWS_WITH(PatrolGraph(data), Catch::Matchers::StartsWith(
                                             "vertex b: a priority must be in 1e-6 … 1e6, got "));
  }
}

TEST_CASE("an edge has one length in both directions") {
  const PatrolGraph sut(Path());

  CHECK(sut.edge_length_m(1, 2) == 4.0);
  CHECK(sut.edge_length_m(2, 1) == 4.0);
}

TEST_CASE("data that breaks a rule is no graph, and the error names the element") {
  GraphData data = Path();

  SECTION("one vertex") {
    data.vertex_ids = {"a"};
    data.positions.resize(1);
    data.edges.clear();
    CHECK_THROWS_WITH(PatrolGraph(data), Equals("a graph must have at least 2 vertices, got 1"));
  }
  SECTION("an id twice") {
    data.vertex_ids[2] = "a";
    CHECK_THROWS_WITH(PatrolGraph(data), Equals("vertex ids must differ, got a twice"));
  }
  SECTION("a position that is not finite") {
    data.positions[1].x_m = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("vertex b: a position must be finite, got (inf, 0)"));
  }
  SECTION("a length of 0") {
    data.edges[0].length_m = 0.0;
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("edge c - b: a length must be positive and finite, got 0"));
  }
  SECTION("a length that is not a number") {
    data.edges[0].length_m = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("edge c - b: a length must be positive and finite, got nan"));
  }
  SECTION("an end that is no vertex") {
    data.edges[1].target = 3;
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("edge 1: an end must be one of the vertices 0 to 2, got 3"));
  }
  SECTION("a loop") {
    data.edges[1].target = 0;
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("an edge must join two vertices, got a loop at vertex a"));
  }
  SECTION("an edge twice, once in each direction") {
    data.edges.push_back({1, 0, 3.0});
    CHECK_THROWS_WITH(PatrolGraph(data), Equals("an edge must stand once, got a - b twice"));
  }
  SECTION("two parts") {
    data.edges.erase(data.edges.begin());
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("a graph must be connected, got no path from vertex a to c"));
  }
  SECTION("no scale") {
    data.metres_per_px = 0.0;
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("metres_per_px must be positive and finite, got 0"));
  }
}

TEST_CASE("a map's closed walk must be one") {
  GraphData data = Path();
  data.shortest_closed_walk = ClosedWalk{{0, 1, 2, 1}, 14.0, "by hand"};

  SECTION("a right one is kept") {
    CHECK(PatrolGraph(data).shortest_closed_walk()->length_m == 14);
  }
  SECTION("a step that is no edge") {
    data.shortest_closed_walk->vertices = {0, 1, 2};
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("shortest_closed_walk.vertices[2]: an edge must join each vertex to "
                             "the next, got none from c to a"));
  }
  SECTION("a vertex missed") {
    data.shortest_closed_walk->vertices = {0, 1};
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("shortest_closed_walk.vertices: the walk must visit every vertex, but "
                             "misses c"));
  }
  SECTION("no vertices") {
    data.shortest_closed_walk->vertices = {};
    CHECK_THROWS_AS(PatrolGraph(data), InputError);
  }
  SECTION("another length") {
    data.shortest_closed_walk->length_m = 14.001;
    CHECK_THROWS_WITH(PatrolGraph(data),
                      Equals("shortest_closed_walk.length_m: the walk's edges sum to 14 m, got "
                             "14.001"));
  }
}

}  // namespace
}  // namespace ronda
