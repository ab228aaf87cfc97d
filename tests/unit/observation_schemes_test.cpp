// The observations of thesis §3.3, §4.4 and §5.1, by values worked out by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "common/base/error.h"
#include "common/environments/observation_encoder.h"
#include "tests/unit/encoded_observation.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

using testing::Encode;
using testing::Observation;
using Numbers = std::vector<double>;

constexpr double kForever = std::numeric_limits<double>::infinity();

/// 1 –1– 0 –2– 2 –3– 3 –2– 4 (m). Distances 0–1 1, 0–2 2, 0–3 5, 0–4 7, 1–2 3, 1–3 6, 1–4 8, 2–3 3,
/// 2–4 5, 3–4 2: mean 4.2 m. From 0 the order is 0, 1, 2, 3, 4; from 3 it is 3, 4, 2, 0, 1.
PatrolGraph Line() {
  return testing::GraphOf(5, {{0, 1, 1.0}, {0, 2, 2.0}, {2, 3, 3.0}, {3, 4, 2.0}});
}

/// Robot 0 (1 m/s) stands at 3 and must decide; the vertices are idle for so long.
PatrolWorld StandingAt3(const PatrolGraph& graph, const Numbers& idleness_s) {
  PatrolWorld world(graph, {.speeds_mps = {1.0}});
  world.Reset(testing::StandingOn({3}), Rng(1));
  for (int v = 0; v < 5; ++v) world.SetLastVisit(v, -idleness_s[v]);
  REQUIRE(world.NextArrival(kForever)->vertex == 3);
  return world;
}

/// The second half of a vector of 2 V, which shows idleness in the order 3, 4, 2, 0, 1.
void CheckIdleness(const ObservationOptions& options, const Numbers& idleness_s,
                   const Numbers& expected) {
  const PatrolGraph graph = Line();
  ObservationEncoder sut(graph, ShortestPaths(graph), options);
  const Observation observation = Encode(sut, StandingAt3(graph, idleness_s), 0);
  REQUIRE(observation.values.size() == 10);
  for (int k = 0; k < 5; ++k) {
    INFO(Schema(options) << ", value " << k);
    CHECK(observation.values[5 + k] == Approx(expected[k]).margin(1e-6));
  }
}

// Of 0, 1, 2, 4, then of 3, which has just been visited; 1 and 2 are equally idle. Mean 4 s.
const Numbers kIdleness_s = {2.0, 4.0, 4.0, 0.0, 10.0};

TEST_CASE("The sorted observation lists distance and idleness, nearest first, and no more") {
  const PatrolGraph graph = Line();
  ObservationEncoder sut(graph, ShortestPaths(graph), ObservationScheme::kSorted);

  const Observation observation = Encode(sut, StandingAt3(graph, kIdleness_s), 0);

  const Numbers distances = {0.0, 2.0 / 4.2, 3.0 / 4.2, 5.0 / 4.2, 6.0 / 4.2};
  REQUIRE(observation.values.size() == 10);
  for (int k = 0; k < 5; ++k) CHECK(observation.values[k] == Approx(distances[k]));
  CHECK(observation.legal == std::vector<std::uint8_t>{0, 1, 1, 0, 0});
  CHECK(sut.NextVertex(3, 1) == 4);
  CHECK(sut.NextVertex(3, 2) == 2);
  CheckIdleness(ObservationScheme::kSorted, kIdleness_s,
                {0.0, std::log(3.5), std::log(2.0), std::log(1.5), std::log(2.0)});
  CheckIdleness(ObservationScheme::kSorted, Numbers(5, 0.0), Numbers(5, 0.0));
}

TEST_CASE("The ranking observation shows rank / V, of equals the lower index the lower rank") {
  CheckIdleness(ObservationScheme::kRanking, kIdleness_s, {0.2, 1.0, 0.8, 0.4, 0.6});
  CheckIdleness(ObservationScheme::kRanking, Numbers(5, 0.0), {0.8, 1.0, 0.6, 0.2, 0.4});
}

TEST_CASE("The normalised observation runs from 0 to 1, and is 0 where all are equally idle") {
  CheckIdleness(ObservationScheme::kNormalised, kIdleness_s, {0.0, 1.0, 0.4, 0.2, 0.4});
  CheckIdleness(ObservationScheme::kNormalised, Numbers(5, 0.0), Numbers(5, 0.0));
}

TEST_CASE("The centred observation shows how far idleness is from the mean, in means") {
  CheckIdleness(ObservationScheme::kCentred, kIdleness_s, {-1.0, 1.5, 0.0, -0.5, 0.0});
}

TEST_CASE("The α transform leaves 0 and 1, and is (α^x − 1)/(α − 1) between them") {
  for (const double alpha : {1.0 + 1e-9, 2.0, 1e5, 1e8, 1e12}) {
    CAPTURE(alpha);
    CHECK(AlphaTransform(0.0, alpha) == 0.0);
    CHECK(AlphaTransform(1.0, alpha) == 1.0);
    double before = 0.0;
    for (int i = 1; i <= 1000; ++i) {
      const double now = AlphaTransform(i / 1000.0, alpha);
      REQUIRE(now > before);
      before = now;
    }
  }
  CHECK(AlphaTransform(0.5, 4.0) == Approx(1.0 / 3.0));
  CHECK(AlphaTransform(0.5, 1e4) == Approx(99.0 / 9999.0));
  CHECK(AlphaTransform(0.2, 1e5) == Approx(9.0 / 99999.0));
  CHECK(AlphaTransform(0.5, 1e8) == Approx(9999.0 / 99999999.0));
  CHECK(AlphaTransform(0.3, 1.0 + 1e-9) == Approx(0.3));  // no cancellation
}

TEST_CASE("With α the normalised and the ranking observation pass through the transform") {
  CheckIdleness({ObservationScheme::kNormalised, 1e5}, kIdleness_s,
                {0.0, 1.0, 99.0 / 99999.0, 9.0 / 99999.0, 99.0 / 99999.0});
  CheckIdleness({ObservationScheme::kRanking, 1e5}, kIdleness_s,
                {9.0 / 99999.0, 1.0, 9999.0 / 99999.0, 99.0 / 99999.0, 999.0 / 99999.0});
}

/// A cycle 0 – 1 – 2 – 3 – 0 with the chord 0 – 2, all edges 4 m.
PatrolGraph FourVertices() {
  return testing::GraphOf(4, {{0, 1, 4.0}, {1, 2, 4.0}, {2, 3, 4.0}, {0, 3, 4.0}, {0, 2, 4.0}});
}

TEST_CASE("The agent-vertex matrix has the rows of the thesis's example, the decider's first") {
  const PatrolGraph graph = FourVertices();
  // The thesis counts from 1: agent 1 at node 2, agent 2 between 1 and 3, agent 3 at node 4.
  ObservationOptions options = ObservationScheme::kMatrix;
  options.robots = 3;
  ObservationEncoder sut(graph, ShortestPaths(graph), options);
  PatrolWorld world(graph, {.speeds_mps = {1.0, 1.0, 1.0}});
  world.Reset(std::vector<RobotStart>{{1, 1, 0.0}, {0, 2, 2.0}, {3, 3, 0.0}}, Rng(1));
  world.SetLastVisit(0, -2.0);
  world.SetLastVisit(2, -6.0);
  REQUIRE(world.NextArrival(kForever)->robot == 0);
  const double third_s = 8.0 / 4.0;  // mean idleness

  const Observation of_first = Encode(sut, world, 0);

  const std::vector<float> first = {0, 1, 0, 0}, second = {0.5, 0, 0.5, 0}, third = {0, 0, 0, 1};
  const auto check = [&](const Observation& observation, int block,
                         const std::vector<float>& expected) {
    INFO("block " << block);
    const auto begin = observation.values.begin() + 4 * block;
    CHECK(std::vector<float>(begin, begin + 4) == expected);
  };
  REQUIRE(of_first.values.size() == 4 * 4);
  check(of_first, 0, first);
  check(of_first, 1, second);
  check(of_first, 2, third);
  CHECK(of_first.values[12] == Approx(std::log1p(2.0 / third_s)));
  CHECK(of_first.values[13] == 0.0f);
  CHECK(of_first.values[14] == Approx(std::log1p(6.0 / third_s)));
  CHECK(of_first.values[15] == 0.0f);
  CHECK(of_first.legal == std::vector<std::uint8_t>{1, 0, 1, 0});
  CHECK(sut.NextVertex(1, 2) == 2);
  world.Depart(0, 2);
  REQUIRE(world.NextArrival(kForever)->robot == 2);
  const Observation of_third = Encode(sut, world, 2);
  check(of_third, 0, third);
  check(of_third, 1, first);
  check(of_third, 2, second);
  CHECK(of_third.legal == std::vector<std::uint8_t>{1, 0, 1, 0});
}

TEST_CASE("On an edge a robot belongs to both ends by its position, and the shares sum to 1") {
  const PatrolGraph graph = FourVertices();
  PatrolWorld world(graph, {.speeds_mps = {2.0, 1.0}});
  // Robot 1 is 3 m before 2, on the edge from 0.
  world.Reset(std::vector<RobotStart>{{1, 1, 0.0}, {0, 2, 3.0}}, Rng(1));
  world.NextArrival(kForever);
  std::vector<float> row(4, 99.0f);

  WriteAffiliation(CompleteBelief(world, 0), 1, row);
  CHECK(row == std::vector<float>{0.75f, 0.0f, 0.25f, 0.0f});

  world.Depart(0, 0);  // there at 2 s, when robot 1 is 1 m before 2
  REQUIRE(world.NextArrival(kForever)->robot == 0);
  WriteAffiliation(CompleteBelief(world, 0), 1, row);
  CHECK(row == std::vector<float>{0.25f, 0.0f, 0.75f, 0.0f});
}

TEST_CASE("Under travel noise the shares of a row still sum to 1") {
  const PatrolGraph graph = FourVertices();
  PatrolWorld world(graph, {.speeds_mps = {1.0, 1.3, 0.7}, .travel_noise = 0.8});
  world.Reset(testing::StandingOn({0, 1, 2}), Rng(5));
  Rng rng(6);
  std::vector<float> row(4);
  for (int i = 0; i < 300; ++i) {
    const auto arrival = world.NextArrival(kForever);
    for (int robot = 0; robot < 3; ++robot) {
      WriteAffiliation(CompleteBelief(world, arrival->robot), robot, row);
      float sum = 0.0f;
      for (const float share : row) {
        REQUIRE(share >= 0.0f);
        sum += share;
      }
      REQUIRE(sum == Approx(1.0));
    }
    const auto next = graph.neighbours(arrival->vertex);
    world.Depart(arrival->robot, next[rng.Below(static_cast<std::uint32_t>(next.size()))]);
  }
}

TEST_CASE("A schema says scheme and α, and both are read back from it") {
  for (const std::string& name : ObservationNames()) {
    const ObservationScheme scheme = ParseObservationScheme(name);
    CHECK(Name(scheme) == name);
    CHECK(SchemeOf(Schema(scheme)).scheme == scheme);
    CHECK(SchemeOf(Schema(scheme)).alpha == 0.0);
  }
  for (const double alpha : {1.1, 1e5, 31622.776601683792, 1e12}) {
    const auto options = SchemeOf(Schema({ObservationScheme::kNormalised, alpha}));
    CHECK(options.scheme == ObservationScheme::kNormalised);
    CHECK(options.alpha == alpha);
  }
  // Policy files have these.
  CHECK(Schema(ObservationScheme::kCandidates) == "patrol-candidates-26");
  CHECK(Schema(ObservationScheme::kThesis) == "patrol-thesis-3");
  CHECK(Schema({ObservationScheme::kNormalised, 1e5}) == "patrol-normalised-2.alpha-100000");
  for (const char* bad : {"", "patrol-normalised", "patrol-normalised-2.alpha-",
                          "patrol-normalised-2.alpha-1", "patrol-normalised-2.alpha-1e5x",
                          "patrol-normalised-2.alpha-inf", "patrol-candidates-26.alpha-100000"}) {
    CHECK_THROWS_AS(SchemeOf(bad), InputError);
  }
}

TEST_CASE("An α out of range or of another scheme, and a matrix of no team, are refused") {
  const PatrolGraph graph = Line();
  const ShortestPaths paths(graph);
  for (const double alpha : {1.0, 0.5, -1e5, kForever}) {
    CHECK_THROWS_AS(ObservationEncoder(graph, paths, {ObservationScheme::kNormalised, alpha}),
                    InputError);
  }
  CHECK_THROWS_WITH(ObservationEncoder(graph, paths, {ObservationScheme::kCentred, 1e5}),
                    Catch::Contains("observation_alpha: must be 0 (off) with the observation "
                                    "centred, got 100000"));
  CHECK_THROWS_AS(ObservationEncoder(graph, paths, ObservationScheme::kMatrix), InputError);
}

}  // namespace
}  // namespace ronda
