#include "common/world/patrol_world.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "common/base/error.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

using testing::GraphOf;
using testing::Path;
using testing::StandingOn;
using testing::Star;

/// One robot's next arrival, which must be there; it goes on to `next`.
Arrival Step(PatrolWorld& world, int next) {
  const auto arrival = world.NextArrival(1e9);
  REQUIRE(arrival);
  world.Depart(arrival->robot, next);
  return *arrival;
}

TEST_CASE("One robot on a path: AGI, WI and final idleness are those computed by hand") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0}});
  sut.Reset(StandingOn({0}), Rng(1));

  CHECK(Step(sut, 1).time_s == 0.0);  // at 0
  CHECK(Step(sut, 2).time_s == 2.0);  // at 1
  const Arrival far = Step(sut, 1);   // at 2
  CHECK(far.time_s == 5.0);
  CHECK(far.vertex == 2);
  CHECK(far.idleness_s == 5.0);
  const Arrival back = Step(sut, 2);  // at 1 again
  CHECK(back.time_s == 8.0);
  CHECK(back.idleness_s == 6.0);
  REQUIRE_FALSE(sut.NextArrival(10.0));
  sut.AdvanceTo(10.0);

  // ∫ per vertex: 10²/2; 2²/2 + 6²/2 + 2²/2; 5²/2 + 5²/2.
  CHECK(sut.average_graph_idleness_s() == Approx((50.0 + 22.0 + 25.0) / 30.0).epsilon(1e-14));
  CHECK(sut.worst_idleness_s() == 10.0);
  CHECK(sut.instantaneous_graph_idleness_s() == Approx(17.0 / 3.0).epsilon(1e-14));
  CHECK(sut.instantaneous_worst_idleness_s() == 10.0);
}

TEST_CASE("A window that begins between visits counts only what lies in it") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0}});
  sut.Reset(StandingOn({0}), Rng(1));
  Step(sut, 1);
  Step(sut, 2);

  REQUIRE_FALSE(sut.NextArrival(4.0));
  sut.AdvanceTo(4.0);
  sut.BeginMeasurement();
  Step(sut, 1);  // t = 5, vertex 2 was idle for 5 s
  Step(sut, 0);  // t = 8, vertex 1 was idle for 6 s
  Step(sut, 1);  // t = 10, vertex 0 was idle for 10 s
  REQUIRE_FALSE(sut.NextArrival(11.0));
  sut.AdvanceTo(11.0);

  const double by_hand_s2 = (100 - 16) / 2.0 + 0.5         // vertex 0: idle 4 → 10, 0 → 1
                            + (36 - 4) / 2.0 + 9.0 / 2.0   // vertex 1: idle 2 → 6, 0 → 3
                            + (25 - 16) / 2.0 + 36.0 / 2;  // vertex 2: idle 4 → 5, 0 → 6
  CHECK(sut.average_graph_idleness_s() == Approx(by_hand_s2 / 21.0).epsilon(1e-14));
  CHECK(sut.worst_idleness_s() == 10.0);
}

TEST_CASE(
    "Two robots that shuttle on the 25 m edges of the 4-node map reach AGI 25 s and WI 50 s") {
  const PatrolGraph graph = GraphOf(
      4, {{0, 1, 40.0}, {0, 2, 25.0}, {0, 3, std::hypot(40.0, 25.0)}, {1, 3, 25.0}, {2, 3, 40.0}});
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0}});
  sut.Reset(StandingOn({0, 1}), Rng(1));
  const auto shuttle_until = [&](double until_s) {
    while (const auto arrival = sut.NextArrival(until_s)) {
      sut.Depart(arrival->robot, (arrival->vertex + 2) % 4);
    }
    sut.AdvanceTo(until_s);
  };

  shuttle_until(100.0);
  sut.BeginMeasurement();
  shuttle_until(1100.0);

  CHECK(sut.average_graph_idleness_s() == 25.0);
  CHECK(sut.worst_idleness_s() == 50.0);
}

TEST_CASE("Of simultaneous arrivals the lower index decides while the others still head there") {
  const PatrolGraph graph = Star(3);
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0, 1.0}});
  sut.Reset(StandingOn({3, 1, 2}), Rng(1));
  for (int robot = 0; robot < 3; ++robot) Step(sut, 0);

  for (int robot = 0; robot < 3; ++robot) {
    const auto arrival = sut.NextArrival(1.0);
    REQUIRE(arrival);
    CHECK(arrival->robot == robot);
    CHECK(arrival->time_s == 1.0);
    CHECK(arrival->idleness_s == (robot == 0 ? 1.0 : 0.0));
    for (int other = robot + 1; other < 3; ++other) {
      CHECK(sut.target(other) == 0);
      CHECK(sut.arrival_s(other) == 1.0);
    }
    for (int other = 0; other < robot; ++other) CHECK(sut.target(other) == other + 1);
    sut.Depart(robot, robot + 1);
  }
  CHECK_FALSE(sut.NextArrival(1.9));
}

TEST_CASE("Two robots that cover the same edges in another order arrive at the same instant") {
  const PatrolGraph graph = GraphOf(7, {{0, 1, 0.1},
                                        {1, 2, 1.0 / 3.0},
                                        {2, 3, 1e5 / 7.0},
                                        {4, 5, 1e5 / 7.0},
                                        {5, 6, 0.1},
                                        {6, 3, 1.0 / 3.0}});
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0}});
  sut.Reset(StandingOn({0, 4}), Rng(1));
  const std::vector<int> next{1, 2, 3, -1, 5, 6, 3};

  while (sut.target(0) != 3 || sut.target(1) != 3) {
    const auto arrival = sut.NextArrival(1e9);
    REQUIRE(arrival);
    sut.Depart(arrival->robot, next[arrival->vertex]);
  }

  CHECK(sut.arrival_s(0) == sut.arrival_s(1));
}

TEST_CASE("The shortest of edges still takes time") {
  const PatrolGraph graph = GraphOf(2, {{0, 1, 1e-15}});
  PatrolWorld sut(graph, {.speeds_mps = {1.0}});
  sut.Reset(StandingOn({0}), Rng(1));

  Step(sut, 1);

  CHECK(Step(sut, 0).time_s == kTimeStep_s);
}

TEST_CASE("A robot twice as fast arrives in half the time") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 2.0}});
  sut.Reset(StandingOn({1, 1}), Rng(1));
  Step(sut, 2);
  Step(sut, 2);

  CHECK(sut.arrival_s(0) == 3.0);
  CHECK(sut.arrival_s(1) == 1.5);
  CHECK(sut.travel_time_s(1, 3.0) == 1.5);
  CHECK(sut.total_speed_mps() == 3.0);
}

TEST_CASE("A robot that starts on an edge arrives after what remains of it") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {0.5}});
  sut.Reset(std::vector<RobotStart>{{.vertex = 1, .next = 2, .remaining_m = 0.75}}, Rng(1));

  CHECK(sut.previous_vertex(0) == 1);
  const Arrival arrival = Step(sut, 1);

  CHECK(arrival.vertex == 2);
  CHECK(arrival.time_s == 1.5);
}

TEST_CASE("Travel noise has mean length/speed and never changes without σ") {
  // 20000 log-normal factors with σ = 0.3: standard error 0.0022; 4 of them, 1 in 16000 by chance.
  const PatrolGraph graph = GraphOf(2, {{0, 1, 1.0}});
  PatrolWorld sut(graph, {.speeds_mps = {1.0}, .travel_noise = 0.3});
  sut.Reset(StandingOn({0}), SplitSeed(11, 0));
  std::vector<double> durations_s;
  double last_s = Step(sut, 1).time_s;
  for (int i = 0; i < 20'000; ++i) {
    const Arrival arrival = Step(sut, i % 2);
    durations_s.push_back(arrival.time_s - last_s);
    last_s = arrival.time_s;
  }

  double log_square = 0.0;
  for (const double duration_s : durations_s) {
    log_square += std::pow(std::log(duration_s) + 0.045, 2) / 20'000.0;
  }
  CHECK(last_s / 20'000.0 == Approx(1.0).margin(0.009));
  CHECK(std::sqrt(log_square) == Approx(0.3).margin(0.006));
}

TEST_CASE("The exact AGI is what sampling the idleness finely finds") {
  const PatrolGraph graph =
      GraphOf(5, {{0, 1, 1.3}, {1, 2, 0.7}, {2, 3, 2.9}, {3, 0, 1.1}, {3, 4, 3.7}, {1, 3, 0.9}});
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 0.6}, .travel_noise = 0.2});
  sut.Reset(StandingOn({0, 4}), SplitSeed(5, 0));
  Rng rng = SplitSeed(5, 1);
  constexpr double kFrom_s = 10.0;
  constexpr double kTo_s = 60.0;
  constexpr double kSample_s = 0.001;
  double sum_s = 0.0;
  double worst_s = 0.0;
  int samples = 0;
  bool measuring = false;
  for (double now_s = 0.5 * kSample_s; now_s < kTo_s; now_s += kSample_s) {
    while (const auto arrival = sut.NextArrival(now_s)) {
      const auto neighbours = graph.neighbours(arrival->vertex);
      sut.Depart(arrival->robot, neighbours[rng.Below(static_cast<unsigned>(neighbours.size()))]);
    }
    if (now_s < kFrom_s) continue;
    if (!std::exchange(measuring, true)) {
      sut.AdvanceTo(now_s);
      sut.BeginMeasurement();
    }
    for (int v = 0; v < 5; ++v) {
      sum_s += now_s - sut.last_visit_s(v);
      worst_s = std::max(worst_s, now_s - sut.last_visit_s(v));
    }
    ++samples;
    sut.AdvanceTo(now_s);
  }

  CHECK(sut.average_graph_idleness_s() == Approx(sum_s / (5.0 * samples)).epsilon(1e-3));
  CHECK(sut.worst_idleness_s() == Approx(worst_s).margin(2 * kSample_s));
}

TEST_CASE("Random starts are distinct, and uniform over the vertices") {
  const PatrolGraph graph = Star(7);
  Rng rng = SplitSeed(3, 0);
  std::vector<int> first(8, 0);
  for (int i = 0; i < 8'000; ++i) {
    const auto starts = PatrolWorld::RandomStarts(graph, 8, rng);
    std::set<int> vertices;
    for (const RobotStart& start : starts) vertices.insert(start.vertex);
    REQUIRE(vertices.size() == 8);
    ++first[starts[0].vertex];
  }

  // χ² with 7 degrees of freedom exceeds 29.9 once in 10000.
  double chi_square = 0.0;
  for (const int count : first) chi_square += (count - 1000.0) * (count - 1000.0) / 1000.0;
  CHECK(chi_square < 29.9);
}

TEST_CASE("More robots than vertices: every vertex gets one before any gets two") {
  const PatrolGraph graph = Path();
  Rng rng = SplitSeed(3, 0);

  const auto starts = PatrolWorld::RandomStarts(graph, 8, rng);

  std::vector<int> count(3, 0);
  for (const RobotStart& start : starts) ++count[start.vertex];
  std::sort(count.begin(), count.end());
  CHECK(count == std::vector<int>{2, 3, 3});
}

TEST_CASE("A copy goes on by itself from the same state") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0}, .travel_noise = 0.5});
  sut.Reset(StandingOn({0}), SplitSeed(9, 0));
  Step(sut, 1);

  PatrolWorld copy = sut;
  const double copy_s = Step(copy, 2).time_s;

  CHECK(sut.time_s() == 0.0);
  CHECK(Step(sut, 2).time_s == copy_s);
  CHECK(sut.arrival_s(0) == copy.arrival_s(0));
}

TEST_CASE("Reset forgets everything") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0}});
  const auto play = [&] {
    sut.Reset(StandingOn({0}), Rng(1));
    Step(sut, 1);
    Step(sut, 2);
    Step(sut, 1);
    return sut.average_graph_idleness_s();
  };

  const double first_s = play();

  CHECK(play() == first_s);
}

TEST_CASE("A world without robots, a speed of 0 and negative noise are refused by name and value") {
  const PatrolGraph graph = Path();

  CHECK_THROWS_WITH(PatrolWorld(graph, {.speeds_mps = {}}),
                    Catch::Contains("at least 1 robot, got 0"));
  CHECK_THROWS_WITH(PatrolWorld(graph, {.speeds_mps = {1.0, 0.0}}),
                    Catch::Contains("robot 1: a speed must be > 0"));
  CHECK_THROWS_AS(PatrolWorld(graph, {.speeds_mps = {1.0}, .travel_noise = -0.1}), InputError);
}

}  // namespace
}  // namespace ronda
