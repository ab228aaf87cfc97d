#include "common/world/fluid_bound.h"

#include <catch2/catch.hpp>

#include "tests/unit/graph/graphs.h"
#include "tests/unit/graph/traversal_rates.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

constexpr int kTrials = 200;

TEST_CASE(
    "no rates of traversal have a mean idleness below the fluid bound, however early it "
    "stopped") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  const bool priorities = GENERATE(false, true);
  CAPTURE(seed, priorities);
  Rng rng = SplitSeed(seed, 1);
  const GraphData data = testing::RandomGraphData(20, 15, seed);
  const PatrolGraph graph =
      priorities ? testing::WithRandomPriorities(data, rng) : PatrolGraph(data);

  const double sut_m = FluidBound_m(graph);

  CHECK(FluidBound_m(graph, 1) < sut_m);
  CHECK(FluidBound_m(graph, 10) < sut_m);
  CHECK(ClosedFormBound_m(graph) < sut_m);
  for (int trial = 0; trial < kTrials; ++trial) {
    REQUIRE(testing::LeastAgi_s(graph, testing::RandomTimeShares(graph, {1.0}, 0.0, rng)) >= sut_m);
  }
}

TEST_CASE("the fluid bound is what robots reach on one edge and on a star") {
  const PatrolGraph edge = testing::GraphOf(2, {{0, 1, 7.0}});
  CHECK(FluidBound_m(edge) == Approx(7.0).epsilon(1e-5));
  CHECK(ClosedFormBound_m(edge) == Approx(7.0));
  // k leaves at 1 m: 2 f = x at a leaf, k x at the centre, k x = 1.
  CHECK(FluidBound_m(testing::Star(5)) == Approx((5.0 * 5.0 + 1.0) / 6.0).epsilon(1e-5));
}

TEST_CASE("priorities: a robot comes to a leaf in proportion to the root of its weight") {
  GraphData data = testing::Star(2).data();
  data.priorities = {1.0, 4.0, 1.0};  // weights 1/2, 2, 1/2
  // x to leaf 1, 1 − x to leaf 2: (1/3) (1/2 + 2/x + (1/2)/(1 − x)), least at x = 2/3.
  CHECK(FluidBound_m(PatrolGraph(data)) == Approx(5.0 / 3.0).epsilon(1e-5));
}

TEST_CASE("no shares of rates and parking have a mean idleness below the parking bound") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 11));
  const bool priorities = GENERATE(false, true);
  CAPTURE(seed, priorities);
  Rng rng = SplitSeed(seed, 2);
  const GraphData data = testing::RandomGraphData(12, 6, seed);
  const PatrolGraph graph =
      priorities ? testing::WithRandomPriorities(data, rng) : PatrolGraph(data);
  std::vector<double> speeds_mps(1 + seed);
  for (double& speed_mps : speeds_mps) speed_mps = 0.1 + rng.Uniform();

  const double sut_s = ParkingBound_s(graph, speeds_mps);

  CHECK(sut_s > 0.0);
  CHECK(ParkingBound_s(graph, speeds_mps, 1) <= sut_s);
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto shares = testing::RandomTimeShares(graph, speeds_mps, 0.99, rng);
    REQUIRE(testing::LeastAgi_s(graph, shares) >= sut_s);
  }
}

TEST_CASE("parking: AGI is best where one robot stands far away and the other shuttles") {
  // 0 –1 m– 1 –100 m– 2
  const PatrolGraph graph = testing::GraphOf(3, {{0, 1, 1.0}, {1, 2, 100.0}});
  CHECK(ParkingBound_s(graph, std::vector{1.0, 1.0}) == Approx(2.0 / 3.0).epsilon(1e-3));
  CHECK(FluidBound_m(graph) / 2.0 > 10.0);
  // The slow one is the one that stands.
  CHECK(ParkingBound_s(graph, std::vector{1.0, 0.01}) == Approx(2.0 / 3.0).epsilon(1e-3));
}

TEST_CASE("parking: with a robot for each vertex nothing is ever idle") {
  CHECK(ParkingBound_s(testing::Star(2), std::vector{1.0, 1.0, 1.0}) == 0.0);
}

TEST_CASE("parking changes the bound on Cumberland from some number of robots on") {
  const PatrolGraph graph = testing::ShippedMap("cumberland");
  const auto px = [&](int robots) {
    return ParkingBound_s(graph, std::vector(robots, graph.metres_per_px()));
  };
  CHECK(px(10) == Approx(FluidBound_m(graph) / graph.metres_per_px() / 10.0).epsilon(1e-5));
  CHECK(px(12) == Approx(110.5).margin(0.05));
}

}  // namespace
}  // namespace ronda
