#include "common/world/bounds.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

struct BoundFacts {
  std::string name;
  double fluid_px = 0.0;
  double covering_px = 0.0;
};

/// (1/V) Σ_v 1 / Σ_{e at v} x_e.
double MeanIdleness(const PatrolGraph& graph, const std::vector<double>& rates) {
  std::vector<double> at_vertex(graph.vertex_count(), 0.0);
  for (int e = 0; e < graph.edge_count(); ++e) {
    at_vertex[graph.edges()[e].source] += rates[e];
    at_vertex[graph.edges()[e].target] += rates[e];
  }
  double sum = 0.0;
  for (const double rate : at_vertex) sum += 1.0 / rate;
  return sum / graph.vertex_count();
}

TEST_CASE("the bounds of the shipped maps are those that docs/maps.md states") {
  const BoundFacts facts = GENERATE(values<BoundFacts>({
      {"4nodes", 50.0, 100.0},
      {"cumberland", 1329.6, 3182.5},
      {"grid", 951.5, 1976.0},
      {"milwaukee", 2061.8, 4307.0},
  }));
  CAPTURE(facts.name);
  const PatrolGraph graph = testing::ShippedMap(facts.name);
  const double px_per_s = graph.metres_per_px();  // robots of 1 px/s

  const LowerBounds sut = ComputeLowerBounds(graph, 4.0 * px_per_s, 4);

  CHECK(sut.agi_s == Approx(facts.fluid_px / 4.0).epsilon(1e-3));
  CHECK(sut.wi_s == Approx(facts.covering_px / 4.0).epsilon(1e-3));
  CHECK(sut.wi_method == "covering linear programme (dual)");
}

TEST_CASE("no feasible rates have a mean idleness below the fluid bound") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  const PatrolGraph graph(testing::RandomGraphData(20, 15, seed));
  const double sut_m = FluidBound_m(graph);
  Rng rng = SplitSeed(seed, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> rates(graph.edge_count());
    double spent = 0.0;
    for (int e = 0; e < graph.edge_count(); ++e) {
      rates[e] = std::exp(2.0 * rng.Normal());
      spent += rates[e] * graph.edges()[e].length_m;
    }
    for (double& rate : rates) rate /= spent;
    REQUIRE(MeanIdleness(graph, rates) >= sut_m);
  }
}

TEST_CASE("the fluid bound is tight: on one edge and on a star it is what a robot reaches") {
  const PatrolGraph edge(testing::RandomGraphData(2, 0, 3));
  CHECK(FluidBound_m(edge) == Approx(edge.mean_edge_length_m()).epsilon(1e-5));

  // A star with k unit edges: 2 f = x at a leaf, k x at the centre, k x = 1.
  GraphData data;
  constexpr int kLeaves = 5;
  for (int v = 0; v <= kLeaves; ++v) {
    data.vertex_ids.push_back(std::to_string(v));
    data.positions.push_back({static_cast<double>(v), 0.0});
    if (v > 0) data.edges.push_back({0, v, 1.0});
  }
  CHECK(FluidBound_m(PatrolGraph(data)) ==
        Approx((kLeaves * kLeaves + 1.0) / (kLeaves + 1)).epsilon(1e-5));
}

TEST_CASE("rates that visit every vertex once cost at least the covering bound") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  const PatrolGraph graph(testing::RandomGraphData(20, 15, seed));
  const double sut_m = CoveringBound_m(graph);
  Rng rng = SplitSeed(seed, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> visits(graph.vertex_count(), 0.0);
    double cost_m = 0.0;
    std::vector<double> rates(graph.edge_count());
    for (int e = 0; e < graph.edge_count(); ++e) {
      rates[e] = std::exp(2.0 * rng.Normal());
      visits[graph.edges()[e].source] += 0.5 * rates[e];
      visits[graph.edges()[e].target] += 0.5 * rates[e];
      cost_m += rates[e] * graph.edges()[e].length_m;
    }
    REQUIRE(cost_m / *std::min_element(visits.begin(), visits.end()) >= sut_m);
  }
}

TEST_CASE("the covering bound lies between twice the fluid bound and a closed walk") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  const PatrolGraph tree(testing::RandomGraphData(20, 0, seed));
  const double tree_m = tree.mean_edge_length_m() * tree.edge_count();

  const double sut_m = CoveringBound_m(tree);

  CHECK(sut_m >= 2.0 * FluidBound_m(tree) * (1.0 - 1e-9));
  CHECK(sut_m <= 2.0 * tree_m);
}

TEST_CASE("the spanning forest loses the N - 1 longest edges of the tree") {
  const PatrolGraph graph({.vertex_ids = {"0", "1", "2", "3"},
                           .positions = {{0, 0}, {1, 0}, {2, 0}, {3, 0}},
                           .edges = {{0, 1, 5.0}, {1, 2, 3.0}, {2, 3, 4.0}, {3, 0, 9.0}}});
  CHECK(SpanningForestBound_m(graph, 1) == 12.0);
  CHECK(SpanningForestBound_m(graph, 2) == 7.0);
  CHECK(SpanningForestBound_m(graph, 3) == 3.0);
  CHECK(SpanningForestBound_m(graph, 4) == 0.0);
  CHECK(SpanningForestBound_m(graph, 9) == 0.0);
}

TEST_CASE("where clusters lie far apart the spanning tree gives the bound on WI") {
  // Two pairs, 1 m across and 100 m apart: covering needs 4 m, the tree has 102 m.
  const PatrolGraph graph({.vertex_ids = {"0", "1", "2", "3"},
                           .positions = {{0, 0}, {1, 0}, {101, 0}, {102, 0}},
                           .edges = {{0, 1, 1.0}, {1, 2, 100.0}, {2, 3, 1.0}}});

  const LowerBounds one = ComputeLowerBounds(graph, 2.0, 1);
  const LowerBounds two = ComputeLowerBounds(graph, 2.0, 2);

  CHECK(one.wi_s == Approx(51.0));
  CHECK(one.wi_method == "minimum spanning tree less its longest edges");
  CHECK(two.wi_s == Approx(2.0));
}

TEST_CASE("bounds need a robot that moves") {
  const PatrolGraph graph(testing::RandomGraphData(3, 0, 1));
  CHECK_THROWS_WITH(ComputeLowerBounds(graph, 0.0, 1),
                    "bounds: the total speed must be positive and finite, got 0 m/s");
  CHECK_THROWS_WITH(ComputeLowerBounds(graph, 1.0, 0),
                    "bounds: there must be at least 1 robot, got 0");
}

}  // namespace
}  // namespace ronda
