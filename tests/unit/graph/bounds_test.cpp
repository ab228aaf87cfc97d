#include "common/world/bounds.h"

#include <catch2/catch.hpp>

#include "common/world/fluid_bound.h"
#include "common/world/spanning_forest.h"
#include "tests/unit/graph/graphs.h"
#include "tests/unit/graph/tiny_patrol.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

LowerBounds BoundsOf(const PatrolGraph& graph, std::vector<double> speeds_mps,
                     bool staying = false) {
  return ComputeLowerBounds(graph, ShortestPaths(graph),
                            {.speeds_mps = std::move(speeds_mps), .staying = staying});
}

struct BoundFacts {
  std::string name;
  double fluid_px = 0.0;
  double covering_px = 0.0;
  double closed_walk_px = 0.0;
};

TEST_CASE("the bounds of the shipped maps are those that docs/bounds.md states") {
  const BoundFacts facts = GENERATE(values<BoundFacts>({
      {"4nodes", 50.0, 100.0, 130.0},
      {"cumberland", 1329.6, 3182.5, 4977.5},
      {"grid", 951.5, 1976.0, 1976.0},
      {"milwaukee", 2061.8, 4307.1, 5872.8},
  }));
  CAPTURE(facts.name);
  const PatrolGraph graph = testing::ShippedMap(facts.name);
  const double px_per_s = graph.metres_per_px();  // robots of 1 px/s

  const LowerBounds one = BoundsOf(graph, {px_per_s});
  const LowerBounds two = BoundsOf(graph, {px_per_s, px_per_s});

  CHECK(one.agi_s == Approx(facts.fluid_px).epsilon(1e-4));
  CHECK(one.wi_s == Approx(facts.closed_walk_px).epsilon(1e-4));
  CHECK(two.agi_s == Approx(facts.fluid_px / 2.0).epsilon(1e-4));
  CHECK(two.wi_s == Approx(facts.covering_px / 2.0).epsilon(1e-4));
  CHECK(two.wi_method == "covering linear programme");
}

struct TinyCase {
  std::string name;
  PatrolGraph graph;
  int robots = 1;
  int most_idle_s = 8;  // longer than it need be
};

PatrolGraph WithPriorities(const PatrolGraph& graph, std::vector<double> priorities) {
  GraphData data = graph.data();
  data.priorities = std::move(priorities);
  return PatrolGraph(std::move(data));
}

std::vector<TinyCase> TinyCases() {
  const PatrolGraph edge = testing::GraphOf(2, {{0, 1, 3.0}});
  const PatrolGraph triangle = testing::GraphOf(3, {{0, 1, 1.0}, {1, 2, 1.0}, {2, 0, 2.0}});
  const PatrolGraph square =
      testing::GraphOf(4, {{0, 1, 1.0}, {1, 2, 1.0}, {2, 3, 1.0}, {3, 0, 1.0}});
  const PatrolGraph pairs = testing::GraphOf(4, {{0, 1, 1.0}, {1, 2, 3.0}, {2, 3, 1.0}});
  return {{"edge", edge, 1, 12},
          {"path", testing::Path(), 1, 14},
          {"path", testing::Path(), 2, 10},
          {"triangle", triangle, 1, 8},
          {"triangle", triangle, 2, 6},
          {"star", testing::Star(3), 1, 9},
          {"star", testing::Star(3), 2, 6},
          {"square", square, 1, 7},
          {"square", square, 2, 5},
          {"pairs", pairs, 2, 6},
          {"path with priorities", WithPriorities(testing::Path(), {1.0, 1.0, 4.0}), 1, 14},
          {"star with priorities", WithPriorities(testing::Star(3), {1.0, 6.0, 1.0, 2.0}), 1, 11},
          {"pairs with priorities", WithPriorities(pairs, {4.0, 1.0, 1.0, 1.0}), 2, 8}};
}

TEST_CASE("no team on a tiny graph does better than the bounds, and some do as well") {
  const bool staying = GENERATE(false, true);
  for (const TinyCase& tiny : TinyCases()) {
    const testing::TinyOptimum optimum(tiny.graph, {.robots = tiny.robots, .staying = staying},
                                       tiny.most_idle_s);
    const double agi_s = optimum.agi_s();
    const double wi_s = optimum.wi_s();

    const LowerBounds sut = BoundsOf(tiny.graph, std::vector(tiny.robots, 1.0), staying);

    CAPTURE(tiny.name, tiny.robots, staying);
    CHECK(sut.agi_s <= agi_s * (1.0 + 1e-9));
    CHECK(sut.wi_s <= wi_s * (1.0 + 1e-9));
    if (tiny.graph.unweighted()) {  // as good as can be
      CHECK(sut.agi_s >= agi_s * 0.94);
      CHECK(sut.wi_s >= wi_s * (1.0 - 1e-6));
    }
  }
}

TEST_CASE("the spanning forest loses the N - 1 longest edges of the tree") {
  const PatrolGraph graph =
      testing::GraphOf(4, {{0, 1, 5.0}, {1, 2, 3.0}, {2, 3, 4.0}, {3, 0, 9.0}});
  const ShortestPaths paths(graph);
  CHECK(SpanningForestBound_m(graph, paths, 1) == 12.0);
  CHECK(SpanningForestBound_m(graph, paths, 2) == 7.0);
  CHECK(SpanningForestBound_m(graph, paths, 3) == 3.0);
  CHECK(SpanningForestBound_m(graph, paths, 4) == 0.0);
  CHECK(SpanningForestBound_m(graph, paths, 9) == 0.0);
}

TEST_CASE("the spanning forest of vertices that count more may give more") {
  // The ends count 3/2 each, the middle 1/1000: between the ends lie 20 m.
  const PatrolGraph graph =
      WithPriorities(testing::GraphOf(3, {{0, 1, 10.0}, {1, 2, 10.0}}), {1500.0, 1.0, 1500.0});
  CHECK(SpanningForestBound_m(graph, ShortestPaths(graph), 1) == Approx(20.0 * graph.weights()[0]));
}

TEST_CASE("where clusters lie far apart the spanning tree gives the bound on WI") {
  // Three pairs, 1 m across and 100 m apart: covering needs 6 m, and so does a robot less than
  // there are pairs; the tree less one edge has 103 m.
  const PatrolGraph graph =
      testing::GraphOf(6, {{0, 1, 1.0}, {1, 2, 100.0}, {2, 3, 1.0}, {3, 4, 100.0}, {4, 5, 1.0}});

  const LowerBounds two = BoundsOf(graph, {1.0, 1.0});
  const LowerBounds three = BoundsOf(graph, {1.0, 1.0, 1.0});

  CHECK(two.wi_s == Approx(103.0 / 2.0));
  CHECK(two.wi_method == "minimum spanning tree less its longest edges");
  CHECK(three.wi_s == Approx(2.0));
}

TEST_CASE("bounds of robots that keep moving depend on the sum of their speeds only") {
  const PatrolGraph graph = testing::ShippedMap("milwaukee");
  const LowerBounds alike = BoundsOf(graph, {1.0, 1.0, 1.0});
  const LowerBounds unlike = BoundsOf(graph, {0.2, 0.3, 2.5});
  CHECK(unlike.agi_s == Approx(alike.agi_s));
  CHECK(unlike.wi_s == Approx(alike.wi_s));
}

TEST_CASE("who may stand still has no larger bounds than who keeps moving") {
  const std::string name = GENERATE("4nodes", "cumberland", "grid", "milwaukee");
  const int robots = GENERATE(1, 2, 3, 4, 12);
  CAPTURE(name, robots);
  const PatrolGraph graph = testing::ShippedMap(name);
  const LowerBounds moving = BoundsOf(graph, std::vector(robots, 1.0));
  const LowerBounds staying = BoundsOf(graph, std::vector(robots, 1.0), true);
  CHECK(staying.agi_s <= moving.agi_s * (1.0 + 1e-6));
  CHECK(staying.wi_s <= moving.wi_s * (1.0 + 1e-6));
  if (robots < graph.vertex_count()) CHECK(staying.agi_s > 0.0);
}

TEST_CASE("bounds need robots that move") {
  const PatrolGraph graph = testing::Path();
  CHECK_THROWS_WITH(BoundsOf(graph, {1.0, 0.0}),
                    "bounds: a speed must be positive and finite, got 0 m/s");
  CHECK_THROWS_WITH(BoundsOf(graph, {}), "bounds: there must be at least 1 robot, got 0");
}

}  // namespace
}  // namespace ronda
