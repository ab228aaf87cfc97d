#include "common/world/covering_bound.h"

#include <catch2/catch.hpp>
#include <limits>

#include "common/world/fluid_bound.h"
#include "tests/unit/graph/graphs.h"
#include "tests/unit/graph/traversal_rates.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

constexpr int kTrials = 200;

PatrolGraph SomeGraph(std::uint64_t seed, bool priorities, Rng& rng) {
  const GraphData data = testing::RandomGraphData(12, 6, seed);
  return priorities ? testing::WithRandomPriorities(data, rng) : PatrolGraph(data);
}

TEST_CASE("no rates of traversal have a worst idleness below the covering bound") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  const bool priorities = GENERATE(false, true);
  CAPTURE(seed, priorities);
  Rng rng = SplitSeed(seed, 1);
  const PatrolGraph graph = SomeGraph(seed, priorities, rng);

  const double sut_m = CoveringBound_m(graph);

  CHECK(sut_m > 0.0);
  for (int trial = 0; trial < kTrials; ++trial) {
    REQUIRE(testing::LeastWi_s(graph, testing::RandomTimeShares(graph, {1.0}, 0.0, rng)) >= sut_m);
  }
}

TEST_CASE("no shares of rates and parking have a worst idleness below the parked covering bound") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  const bool priorities = GENERATE(false, true);
  CAPTURE(seed, priorities);
  Rng rng = SplitSeed(seed, 2);
  const PatrolGraph graph = SomeGraph(seed, priorities, rng);
  std::vector<double> speeds_mps(1 + seed);
  for (double& speed_mps : speeds_mps) speed_mps = 0.1 + rng.Uniform();

  const double sut_s = ParkedCoveringBound_s(graph, speeds_mps);

  CHECK(sut_s > 0.0);
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto shares = testing::RandomTimeShares(graph, speeds_mps, 0.99, rng);
    REQUIRE(testing::LeastWi_s(graph, shares) >= sut_s);
  }
}

TEST_CASE("whatever duals a solver leaves behind, the bound made of them holds") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  CAPTURE(seed);
  Rng rng = SplitSeed(seed, 3);
  const PatrolGraph graph = SomeGraph(seed, true, rng);
  const std::vector<double> speeds_mps{1.0, 0.3};
  const double best_m = CoveringBound_m(graph);
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> bad_m(graph.vertex_count());
    for (double& dual_m : bad_m) dual_m = 50.0 * rng.Normal();
    bad_m[rng.Below(graph.vertex_count())] = std::numeric_limits<double>::quiet_NaN();
    bad_m[rng.Below(graph.vertex_count())] = std::numeric_limits<double>::infinity();

    const std::vector<double> sut_m = FeasibleCoveringDuals_m(graph, bad_m);

    for (const Edge& edge : graph.edges()) {
      REQUIRE(sut_m[edge.source] + sut_m[edge.target] <= edge.length_m * (1.0 + 1e-12));
    }
    REQUIRE(CoveringBoundOf_m(graph, sut_m) > 0.0);
    REQUIRE(CoveringBoundOf_m(graph, sut_m) <= best_m * (1.0 + 1e-9));
    const auto shares = testing::RandomTimeShares(graph, speeds_mps, 0.99, rng);
    REQUIRE(testing::LeastWi_s(graph, shares) >= ParkedCoveringBoundOf_s(graph, speeds_mps, sut_m));
  }
}

TEST_CASE("the covering bound lies between twice the fluid bound and a closed walk") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 21));
  CAPTURE(seed);
  const PatrolGraph tree(testing::RandomGraphData(20, 0, seed));

  const double sut_m = CoveringBound_m(tree);

  CHECK(sut_m >= 2.0 * FluidBound_m(tree) * (1.0 - 1e-9));
  CHECK(sut_m <= 2.0 * tree.mean_edge_length_m() * tree.edge_count());
}

TEST_CASE("priorities: a leaf that counts twice as much needs twice the visits") {
  GraphData data = testing::Star(2).data();
  data.priorities = {1.0, 2.0, 1.0};  // weights 3/4, 3/2, 3/4
  CHECK(CoveringBound_m(PatrolGraph(data)) == Approx(2.0 * (1.5 + 0.75)));
}

TEST_CASE("parking: WI is best where one robot stands far away and the other shuttles") {
  // 0 –1 m– 1 –100 m– 2
  const PatrolGraph graph = testing::GraphOf(3, {{0, 1, 1.0}, {1, 2, 100.0}});
  CHECK(ParkedCoveringBound_s(graph, std::vector{1.0, 1.0}) == Approx(2.0));
  CHECK(ParkedCoveringBound_s(graph, std::vector{0.01, 1.0}) == Approx(2.0));
  CHECK(CoveringBound_m(graph) / 2.0 > 100.0);
  CHECK(ParkedCoveringBound_s(graph, std::vector{1.0, 1.0, 1.0}) == 0.0);
}

}  // namespace
}  // namespace ronda
