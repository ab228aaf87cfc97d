#include "common/world/random_graph.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

/// Twice the signed area of a triangle.
double Turn(const Position& a, const Position& b, const Position& c) {
  return (b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m);
}

bool Cross(const PatrolGraph& graph, const Edge& a, const Edge& b) {
  if (a.source == b.source || a.source == b.target || a.target == b.source || a.target == b.target)
    return false;
  const auto& at = graph.positions();
  return Turn(at[a.source], at[a.target], at[b.source]) *
                 Turn(at[a.source], at[a.target], at[b.target]) <=
             0.0 &&
         Turn(at[b.source], at[b.target], at[a.source]) *
                 Turn(at[b.source], at[b.target], at[a.target]) <=
             0.0;
}

bool SamePlaces(const PatrolGraph& a, const PatrolGraph& b) {
  return std::ranges::equal(a.positions(), b.positions(), [](const Position& p, const Position& q) {
    return p.x_m == q.x_m && p.y_m == q.y_m;
  });
}

bool SameEdges(const PatrolGraph& a, const PatrolGraph& b) {
  return std::ranges::equal(a.edges(), b.edges(), [](const Edge& e, const Edge& f) {
    return e.source == f.source && e.target == f.target && e.length_m == f.length_m;
  });
}

/// The Gabriel graph by its definition.
int GabrielEdgeCount(const PatrolGraph& graph) {
  const auto& at = graph.positions();
  const auto squared = [&](int a, int b) {
    return (at[a].x_m - at[b].x_m) * (at[a].x_m - at[b].x_m) +
           (at[a].y_m - at[b].y_m) * (at[a].y_m - at[b].y_m);
  };
  int count = 0;
  for (int a = 0; a < graph.vertex_count(); ++a) {
    for (int b = a + 1; b < graph.vertex_count(); ++b) {
      bool is_empty = true;
      for (int c = 0; c < graph.vertex_count(); ++c) {
        is_empty &= c == a || c == b || squared(a, c) + squared(b, c) > squared(a, b);
      }
      count += is_empty ? 1 : 0;
    }
  }
  return count;
}

TEST_CASE("a random map has the vertices, degree and mean edge asked for, and no edges cross") {
  const int vertices = GENERATE(2, 3, 4, 5, 10, 40, 200);
  const double degree = GENERATE(2.0, 2.5, 3.0);
  const auto seed = GENERATE(range<std::uint64_t>(0, 5));
  CAPTURE(vertices, degree, seed);

  // Connected, or the constructor throws.
  const PatrolGraph sut = RandomGeometricGraph(
      {.vertices = vertices, .seed = seed, .degree = degree, .mean_edge_m = 7.0});

  CHECK(sut.vertex_count() == vertices);
  CHECK(sut.mean_edge_length_m() == Approx(7.0).epsilon(1e-9));
  const auto wanted = static_cast<int>(std::lround(vertices * degree / 2.0));
  CHECK(sut.edge_count() >= vertices - 1);
  CHECK(sut.edge_count() <= std::max(vertices - 1, wanted));
  if (vertices >= 40) CHECK(sut.edge_count() == std::max(vertices - 1, wanted));
  for (int e = 0; e < sut.edge_count(); ++e) {
    for (int f = 0; f < e; ++f) {
      if (Cross(sut, sut.edges()[e], sut.edges()[f])) FAIL("edges " << e << " and " << f);
    }
  }
}

TEST_CASE("no two points of a random map are nearer than half the side over the root of V") {
  const int vertices = GENERATE(2, 9, 100, 400);
  const auto seed = GENERATE(range<std::uint64_t>(0, 5));
  const PatrolGraph sut = RandomGeometricGraph({.vertices = vertices, .seed = seed});
  double nearest_m = std::numeric_limits<double>::infinity();
  double side_m = 0.0;  // of the square around the points, which lies in that of the map
  for (const Position& a : sut.positions()) {
    for (const Position& b : sut.positions()) {
      if (&a != &b) nearest_m = std::min(nearest_m, Distance_m(a, b));
      side_m = std::max({side_m, std::abs(a.x_m - b.x_m), std::abs(a.y_m - b.y_m)});
    }
  }
  CHECK(nearest_m >= 0.5 * side_m / std::sqrt(vertices) * (1.0 - 1e-5));
}

TEST_CASE("a random map asked for more edges than its Gabriel graph has is that graph") {
  const int vertices = GENERATE(3, 4, 5, 15, 30, 60);
  const auto seed = GENERATE(range<std::uint64_t>(0, 5));
  CAPTURE(vertices, seed);
  const PatrolGraph sut = RandomGeometricGraph({.vertices = vertices, .seed = seed, .degree = 4.0});
  CHECK(sut.edge_count() == std::min(GabrielEdgeCount(sut), 2 * vertices));
}

TEST_CASE("one seed gives one random map, another gives another") {
  const RandomGraphOptions options{.vertices = 50, .seed = 11};
  const PatrolGraph sut = RandomGeometricGraph(options);
  const PatrolGraph again = RandomGeometricGraph(options);
  CHECK(SamePlaces(sut, again));
  CHECK(SameEdges(sut, again));
  for (std::uint64_t seed = 12; seed < 32; ++seed) {
    CHECK_FALSE(SamePlaces(sut, RandomGeometricGraph({.vertices = 50, .seed = seed})));
  }
}

TEST_CASE("a random map is the same on every machine and in every version") {
  const PatrolGraph sut = RandomGeometricGraph({.vertices = 6, .seed = 3});
  std::string edges;
  for (const Edge& edge : sut.edges()) {
    edges += std::to_string(edge.source) + "-" + std::to_string(edge.target) + " ";
  }
  CHECK(edges == "0-2 0-5 1-5 3-4 4-5 ");
  CHECK(sut.positions()[0].x_m == Approx(12.5845372681));
}

TEST_CASE("the largest random map is connected") {
  const PatrolGraph sut = RandomGeometricGraph({.vertices = 10000, .seed = 1});
  CHECK(sut.edge_count() == 12500);
}

TEST_CASE("a random map is loaded by its name, which it bears") {
  const PatrolGraph sut = LoadMap("random:40:7", "", EdgeLengthSource::kEuclidean, nullptr);
  CHECK(sut.name() == "random:40:7");
  CHECK(SamePlaces(sut, RandomGeometricGraph({.vertices = 40, .seed = 7})));
  CHECK(LoadMap("random:2:18446744073709551615", "", EdgeLengthSource::kEuclidean, nullptr)
            .edge_count() == 1);
}

TEST_CASE("a random map comes back from both formats") {
  const PatrolGraph graph = RandomGeometricGraph({.vertices = 60, .seed = 5});
  const std::string name = GENERATE("m.json", "m.graph");
  const testing::MapFile file(name, "");
  if (name == "m.json") WriteNodeLink(graph, file.path());
  if (name == "m.graph") WriteDotGraph(graph, file.path(), nullptr);

  const PatrolGraph sut = ReadGraphFile(file.path(), EdgeLengthSource::kEuclidean, nullptr);

  REQUIRE(sut.edge_count() == graph.edge_count());
  for (int e = 0; e < graph.edge_count(); ++e) {
    CHECK(sut.edges()[e].source == graph.edges()[e].source);
    CHECK(sut.edges()[e].target == graph.edges()[e].target);
    CHECK(sut.edges()[e].length_m == Approx(graph.edges()[e].length_m).epsilon(1e-9));
  }
}

TEST_CASE("a random map that cannot be is an error with rule and value") {
  const auto load = [](const std::string& name) {
    return LoadMap(name, "", EdgeLengthSource::kEuclidean, nullptr);
  };
  for (const std::string name : {"random:", "random:40", "random:40:", "random::7", "random:x:7",
                                 "random:40:-7", "random:40:7:1", "random:40:7 "}) {
    CHECK_THROWS_WITH(load(name), Catch::Contains("random:VERTICES:SEED") &&
                                      Catch::EndsWith("got '" + name + "'"));
  }
  CHECK_THROWS_WITH(load("random:1:7"),
                    "a random map: the number of vertices must be in 2 … 10000, got 1");
  CHECK_THROWS_WITH(load("random:10001:7"), Catch::EndsWith("got 10001"));
  CHECK_THROWS_AS(RandomGeometricGraph({.degree = 1.9}), InputError);
  CHECK_THROWS_AS(RandomGeometricGraph({.degree = 4.1}), InputError);
  CHECK_THROWS_AS(RandomGeometricGraph({.mean_edge_m = std::nan("")}), InputError);
}

}  // namespace
}  // namespace ronda
