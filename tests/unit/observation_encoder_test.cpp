#include "common/environments/observation_encoder.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/world/graph_file.h"
#include "tests/unit/candidate_reference.h"
#include "tests/unit/encoded_observation.h"

namespace ronda {
namespace {

using testing::Encode;
using testing::Observation;

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr int kFeatures = CandidateEncoder::kFeatures;

PatrolGraph Graph(int vertices, std::vector<Edge> edges) {
  GraphData data;
  data.name = "test";
  data.edges = std::move(edges);
  for (int v = 0; v < vertices; ++v) {
    data.vertex_ids.push_back(std::to_string(v));
    data.positions.push_back({.x_m = static_cast<double>(v), .y_m = 0.0});
  }
  return PatrolGraph(std::move(data));
}

/// 1 –1– 0 –2– 2 –3– 3 –2– 4: the mean edge is 2 m, so distances in units are half of those in m.
PatrolGraph Line() { return Graph(5, {{0, 1, 1.0}, {0, 2, 2.0}, {2, 3, 3.0}, {3, 4, 2.0}}); }

/// Robot 0 has just come from 1 to 0, at 0.5 s; robot 1 is `other_left_m` before `other_target`.
/// Idleness in units: 0, 3, 1, 2, 4 (mean 2) where robot 1 is on its way since before.
PatrolWorld LineWorld(const PatrolGraph& graph, const RobotStart& other) {
  PatrolWorld world(graph, {.speeds_mps = {1.0, 1.0}});
  world.Reset(std::vector<RobotStart>{{.vertex = 1, .next = 0, .remaining_m = 0.5}, other}, Rng(1));
  const double idleness_s[] = {0.0, 6.0, 2.0, 4.0, 8.0};
  for (int v = 0; v < 5; ++v) world.SetLastVisit(v, std::min(0.0, 0.5 - idleness_s[v]));
  REQUIRE(world.NextArrival(kForever)->vertex == 0);
  return world;
}

TEST_CASE("Each of the 26 features has the value that its definition gives by hand") {
  const PatrolGraph graph = Line();
  ObservationEncoder sut(graph, ShortestPaths(graph), ObservationScheme::kCandidates);
  // Robot 1 is 0.75 units before 3: it can be at 4 in 1.75, at 2 in 2.25, at 0 in 3.25, at 1 in
  // 3.75 units.
  const PatrolWorld world = LineWorld(graph, {.vertex = 2, .next = 3, .remaining_m = 2.0});

  const Observation observation = Encode(sut, world, 0);

  const auto near = [](double reach, double one, double two, double four,
                       std::vector<double> distances) {
    double weights = 0.0;
    for (const double distance : distances) weights += std::exp(-distance / reach);
    return (3.0 * std::exp(-one / reach) + std::exp(-two / reach) +
            4.0 * (four < 0.0 ? 0.0 : std::exp(-four / reach))) /
           weights / 2.0;
  };
  const std::vector<double> from_1 = {0.5, 0.0, 1.5, 3.0, 4.0};
  const std::vector<double> from_2 = {1.0, 1.5, 0.0, 1.5, 2.5};
  const std::vector<double> expected = {
      // To 1, at 0.5 units. Own: 0, 1, 2. Behind: 1.
      0.5, 1.5, 1.75, 0.0, std::log(2.75) - std::log(0.6), 1.625, std::exp(-1.875), 1.0 / 3.0, 1.0,
      near(1.0, 0.0, 1.5, 4.0, from_1), near(3.0, 0.0, 1.5, 4.0, from_1),
      near(9.0, 0.0, 1.5, 4.0, from_1), near(1.0, 0.0, 1.5, -1.0, from_1),
      near(3.0, 0.0, 1.5, -1.0, from_1), near(9.0, 0.0, 1.5, -1.0, from_1),
      std::log1p(3.5 / 0.8 / 2.0), std::log1p(3.5 / 0.8 / 2.0), 0.4, 0.75, 0.0, 1.5, 0.75, 1.6,
      2.0 / 3.0, 0.75, std::log(0.801),
      // To 2, at 1 unit. Own: 0, 1, 2. Behind: 2, 3, 4.
      1.0, 0.5, 1.0, 0.0, std::log(2.0) - std::log(1.1), 0.625, std::exp(-1.125), 2.0 / 3.0, 0.0,
      near(1.0, 1.5, 0.0, 2.5, from_2), near(3.0, 1.5, 0.0, 2.5, from_2),
      near(9.0, 1.5, 0.0, 2.5, from_2), near(1.0, 1.5, 0.0, -1.0, from_2),
      near(3.0, 1.5, 0.0, -1.0, from_2), near(9.0, 1.5, 0.0, -1.0, from_2),
      std::log1p(7.5 / 3.8 / 2.0), std::log1p(2.0 / 1.3 / 2.0), 0.4, 0.25, 0.0, 0.5, 0.25, 1.6,
      2.0 / 3.0, 0.25, std::log(0.801)};
  REQUIRE(observation.values.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("candidate " << i / kFeatures << ", " << kCandidateFeatureNames[i % kFeatures]);
    CHECK(observation.values[i] == Approx(expected[i]).margin(1e-5));
  }
  CHECK(observation.legal == std::vector<std::uint8_t>{1, 1});
}

TEST_CASE("A candidate that another robot reaches before shows the claim and the reset idleness") {
  const PatrolGraph graph = Line();
  ObservationEncoder sut(graph, ShortestPaths(graph), ObservationScheme::kCandidates);
  // Robot 1 is 0.25 units before 2, which robot 0 could reach in 1 unit.
  const PatrolWorld world = LineWorld(graph, {.vertex = 3, .next = 2, .remaining_m = 1.0});

  const Observation observation = Encode(sut, world, 0);

  const float* const to_2 = &observation.values[kFeatures];
  CHECK(to_2[1] == Approx(0.5));               // still idle for 1 unit
  CHECK(to_2[2] == Approx(0.75 / 2.0));        // on arrival: since the other's visit
  CHECK(to_2[3] == 1.0f);                      // claimed
  CHECK(to_2[5] == Approx(-0.375));            // lead
  CHECK(to_2[6] == Approx(std::exp(-0.125)));  // crowding
  CHECK(to_2[19] == Approx(-0.375));           // claimed lead
  CHECK(observation.values[3] == 0.0f);
  CHECK(observation.values[19] == 0.0f);
}

TEST_CASE("A vertex that another robot reaches at the same time is not the robot's own") {
  Rng rng(11);
  for (int i = 0; i < 500; ++i) {
    // Robot 1 is as far from 2 as robot 0 at 0 is, by way of 1; so they tie at 2, 3 and 4.
    const double first_m = 0.1 + rng.Uniform();
    const double second_m = 0.1 + rng.Uniform();
    const double third_m = first_m + second_m;
    const PatrolGraph graph =
        Graph(5, {{0, 1, first_m}, {1, 2, second_m}, {2, 3, third_m}, {3, 4, 0.1 + rng.Uniform()}});
    ObservationEncoder sut(graph, ShortestPaths(graph), ObservationScheme::kCandidates);
    PatrolWorld world(graph, {.speeds_mps = {3.0, 3.0}});
    world.Reset(std::vector<RobotStart>{{.vertex = 0}, {3, 2, third_m}}, Rng(1));
    world.NextArrival(0.0);

    const Observation observation = Encode(sut, world, 0);

    INFO("draw " << i << ": " << first_m << " m, " << second_m << " m");
    REQUIRE(observation.values[17] == Approx(2.0 / 5.0));  // vertex 1 alone, N/V
  }
}

TEST_CASE("Neighbours that do not exist are rows of zeros and not legal") {
  const PatrolGraph graph = Line();
  ObservationEncoder sut(graph, ShortestPaths(graph), ObservationScheme::kCandidates);
  PatrolWorld world(graph, {.speeds_mps = {1.0}});
  world.Reset(std::vector<RobotStart>{{.vertex = 4}}, Rng(1));
  world.NextArrival(0.0);

  const Observation observation = Encode(sut, world, 0);

  CHECK(observation.legal == std::vector<std::uint8_t>{1, 0});
  CHECK(sut.NextVertex(4, 0) == 3);
  CHECK(observation.values[0] == Approx(1.0));
  CHECK(observation.values[5] == Approx(2.0));  // alone: nobody else is ever there
  CHECK(std::all_of(observation.values.begin() + kFeatures, observation.values.end(),
                    [](float value) { return value == 0.0f; }));
}

/// A team that has moved about for a while, from some starts.
struct Played {
  Played(const PatrolGraph& graph, std::vector<double> speeds_mps, double noise, int arrivals,
         std::uint64_t seed)
      : world(graph, {.speeds_mps = std::move(speeds_mps), .travel_noise = noise}) {
    Rng rng(seed);
    world.Reset(PatrolWorld::RandomStarts(graph, world.robot_count(), rng), Rng(seed + 1));
    for (int i = 0; i < arrivals; ++i) Move(rng);
    robot = world.NextArrival(kForever)->robot;
  }
  void Move(Rng& rng) {
    const auto arrival = world.NextArrival(kForever);
    const auto neighbours = world.graph().neighbours(arrival->vertex);
    world.Depart(arrival->robot,
                 neighbours[rng.Below(static_cast<std::uint32_t>(neighbours.size()))]);
  }
  PatrolWorld world;
  int robot = 0;
};

PatrolGraph Map(const std::string& name) {
  return LoadMap(name, RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
}

TEST_CASE("The tables give what plain loops in double give, for mixed speeds and noise too") {
  const std::string map = GENERATE("cumberland", "grid", "milwaukee", "4nodes");
  const int robots = GENERATE(1, 3, 10);
  const PatrolGraph graph = Map(map);
  const ShortestPaths paths(graph);
  ObservationEncoder sut(graph, paths, ObservationScheme::kCandidates);
  std::vector<double> speeds_mps;
  for (int k = 0; k < robots; ++k) speeds_mps.push_back(0.5 + 0.37 * k);
  for (int arrivals = 0; arrivals < 400; arrivals += 19) {
    const Played played(graph, speeds_mps, 0.2, arrivals, 17 + arrivals);

    const Observation observation = Encode(sut, played.world, played.robot);

    const auto reference = ReferenceCandidateFeatures(played.world, paths, played.robot);
    for (std::size_t k = 0; k < reference.size(); ++k) {
      for (int f = 0; f < kFeatures; ++f) {
        INFO(map << ", N = " << robots << ", " << arrivals << " arrivals, candidate " << k << ", "
                 << kCandidateFeatureNames[f]);
        REQUIRE(observation.values[k * kFeatures + f] ==
                Approx(reference[k][f]).epsilon(1e-4).margin(1e-4));
      }
    }
  }
}

TEST_CASE("Renaming the vertices reorders the candidates and changes nothing else") {
  const PatrolGraph graph = Map("grid");  // many equal lengths: ties must not depend on names
  std::vector<int> renamed(graph.vertex_count());
  std::iota(renamed.begin(), renamed.end(), 0);
  Rng rng(5);
  for (std::size_t i = renamed.size() - 1; i > 0; --i) {
    std::swap(renamed[i], renamed[rng.Below(static_cast<std::uint32_t>(i + 1))]);
  }
  std::vector<Edge> edges = graph.edges();
  for (Edge& edge : edges) edge = {renamed[edge.source], renamed[edge.target], edge.length_m};
  const PatrolGraph other_graph = Graph(graph.vertex_count(), edges);
  ObservationEncoder sut(graph, ShortestPaths(graph), ObservationScheme::kCandidates);
  ObservationEncoder other(other_graph, ShortestPaths(other_graph), ObservationScheme::kCandidates);
  PatrolWorld world(graph, {.speeds_mps = std::vector<double>(4, 1.0)});
  PatrolWorld other_world(other_graph, {.speeds_mps = std::vector<double>(4, 1.0)});
  auto starts = PatrolWorld::RandomStarts(graph, 4, rng);
  world.Reset(starts, Rng(1));
  for (RobotStart& start : starts) start = {renamed[start.vertex], renamed[start.next], 0.0};
  other_world.Reset(starts, Rng(1));

  for (int step = 0; step < 200; ++step) {
    const auto arrival = world.NextArrival(kForever);
    REQUIRE(other_world.NextArrival(kForever)->vertex == renamed[arrival->vertex]);
    const Observation observation = Encode(sut, world, arrival->robot);
    const Observation others = Encode(other, other_world, arrival->robot);
    const auto neighbours = graph.neighbours(arrival->vertex);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const auto others_neighbours = other_graph.neighbours(renamed[arrival->vertex]);
      const auto other_k =
          std::find(others_neighbours.begin(), others_neighbours.end(), renamed[neighbours[k]]) -
          others_neighbours.begin();
      for (int f = 0; f < kFeatures; ++f) {
        INFO("step " << step << ", " << kCandidateFeatureNames[f]);
        REQUIRE(others.values[other_k * kFeatures + f] ==
                Approx(observation.values[k * kFeatures + f]).epsilon(1e-4).margin(1e-4));
      }
    }
    const int next = neighbours[rng.Below(static_cast<std::uint32_t>(neighbours.size()))];
    world.Depart(arrival->robot, next);
    other_world.Depart(arrival->robot, renamed[next]);
  }
}

TEST_CASE("A team twice as fast, at half the times, observes the same") {
  const auto name = GENERATE(from_range(ObservationNames()));
  ObservationOptions options = ParseObservationScheme(name);
  options.robots = 3;
  const PatrolGraph graph = Map("cumberland");
  ObservationEncoder sut(graph, ShortestPaths(graph), options);
  for (int arrivals = 0; arrivals < 200; arrivals += 23) {
    const Played slow(graph, {1.0, 1.5, 0.75}, 0.0, arrivals, 3);
    const Played fast(graph, {2.0, 3.0, 1.5}, 0.0, arrivals, 3);
    REQUIRE(fast.robot == slow.robot);
    REQUIRE(fast.world.time_s() == Approx(slow.world.time_s() / 2.0));

    const Observation of_slow = Encode(sut, slow.world, slow.robot);
    const Observation of_fast = Encode(sut, fast.world, fast.robot);

    for (std::size_t i = 0; i < of_slow.values.size(); ++i) {
      REQUIRE(of_fast.values[i] == Approx(of_slow.values[i]).epsilon(1e-4).margin(1e-4));
    }
  }
}

TEST_CASE(
    "The thesis observation lists distance, idleness and the others' arrival, nearest first") {
  const PatrolGraph graph = Line();
  const ShortestPaths paths(graph);
  ObservationEncoder sut(graph, paths, ObservationScheme::kThesis);
  const PatrolWorld world = LineWorld(graph, {.vertex = 2, .next = 3, .remaining_m = 2.0});

  const Observation observation = Encode(sut, world, 0);

  // Distances in m: 0–1 1, 0–2 2, 0–3 5, 0–4 7, 1–2 3, 1–3 6, 1–4 8, 2–3 3, 2–4 5, 3–4 2: mean 4.2.
  // The order from 0 is 0, 1, 2, 3, 4; robot 1 is 1.5 m before 3.
  const std::vector<double> expected = {
      0.0,       1.0 / 4.2,           2.0 / 4.2,     5.0 / 4.2,     7.0 / 4.2,      //
      0.0,       std::log(1.0 + 1.5), std::log(1.5), std::log(2.0), std::log(3.0),  //
      6.5 / 4.2, 7.5 / 4.2,           4.5 / 4.2,     1.5 / 4.2,     3.5 / 4.2};
  REQUIRE(observation.values.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("value " << i);
    CHECK(observation.values[i] == Approx(expected[i]).margin(1e-6));
  }
  CHECK(observation.legal == std::vector<std::uint8_t>{0, 1, 1, 0, 0});
  CHECK(sut.NextVertex(0, 2) == 2);
  CHECK(sut.NextVertex(4, 1) == 3);
}

TEST_CASE("Observations are chosen by name, and an unknown name is answered with the known ones") {
  CHECK(ParseObservationScheme("candidates") == ObservationScheme::kCandidates);
  CHECK(ParseObservationScheme("thesis") == ObservationScheme::kThesis);
  CHECK_THROWS_AS(ParseObservationScheme("pixels"), UsageError);
  CHECK_THROWS_WITH(ParseObservationScheme("pixels"),
                    Catch::Contains("candidates, thesis, sorted") && Catch::Contains("'pixels'"));
}

}  // namespace
}  // namespace ronda
