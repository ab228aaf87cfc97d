// The patrolled world where robots fail, join, stay put, or vertices count differently.
#include <catch2/catch.hpp>
#include <vector>

#include "common/base/error.h"
#include "common/world/patrol_world.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

using testing::Path;
using testing::StandingOn;
using testing::Star;

/// Plays to `until_s`; each robot goes back and forth over its first edge. How often each arrived.
std::vector<int> Shuttle(PatrolWorld& world, double until_s) {
  std::vector<int> arrivals(static_cast<std::size_t>(world.robot_count()), 0);
  while (const auto arrival = world.NextArrival(until_s)) {
    ++arrivals[arrival->robot];
    world.Depart(arrival->robot, world.graph().neighbours(arrival->vertex)[0]);
  }
  world.AdvanceTo(until_s);
  return arrivals;
}

TEST_CASE("A robot that fails arrives nowhere any more, one that joins begins where it starts") {
  const PatrolGraph graph = Star(3);
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0, 1.0}});
  sut.Reset(StandingOn({0, 2, 3}), Rng(1));
  sut.Schedule(std::vector<RobotChange>{{.time_s = 2.5, .robot = 1},
                                        {.time_s = 4.25, .robot = 2, .joins = true},
                                        {.time_s = 5.0, .robot = 1, .joins = true}});

  CHECK(sut.on_patrol()[2] == 0);
  CHECK(sut.target(2) == -1);
  CHECK(Shuttle(sut, 3.0) == std::vector<int>{4, 3, 0});  // robot 1 at 0, 1 and 2
  CHECK(sut.on_patrol()[1] == 0);
  CHECK(sut.expected_arrivals_s()[1] == kNever_s);
  CHECK(sut.last_visit_s(3) == 0.0);                      // nobody stood there
  CHECK(Shuttle(sut, 6.0) == std::vector<int>{3, 2, 2});  // 4, 5, 6; 5, 6; 4.25, 5.25
  CHECK(sut.last_visit_s(3) == 4.25);
  CHECK(sut.last_visit_s(2) == 5.0);  // robot 1, where it started
}

TEST_CASE("A robot fails before it arrives at that very moment") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0}});
  sut.Reset(StandingOn({0, 2}), Rng(1));
  sut.Schedule(std::vector<RobotChange>{{.time_s = 3.0, .robot = 1}});

  CHECK(Shuttle(sut, 3.0)[1] == 1);
  CHECK(sut.last_visit_s(1) == 2.0);  // robot 0 alone
}

TEST_CASE("A robot that joins on an edge starts there each time") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 2.0}});
  sut.Reset(std::vector<RobotStart>{{.vertex = 2, .next = 2},
                                    {.vertex = 0, .next = 1, .remaining_m = 1.0}},
            Rng(1));
  sut.Schedule(std::vector<RobotChange>{{.time_s = 10.0, .robot = 1, .joins = true}});

  Shuttle(sut, 10.25);
  CHECK(sut.target(1) == 1);
  CHECK(sut.arrival_s(1) == 10.5);
  CHECK(sut.position(1).x_m == 0.0);  // all of this map's vertices are on one point
}

TEST_CASE("A robot that stays put keeps its vertex at idleness 0 for so long") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0}, .stay_s = 6.0});
  sut.Reset(StandingOn({0, 0}), Rng(1));
  sut.NextArrival(0.0);
  sut.Depart(0, 0);  // stays until 6
  sut.NextArrival(0.0);
  sut.Depart(1, 1);  // at 1 at 2, back at 0 at 4, at 1 at 6 …
  CHECK(sut.NextArrival(2.0)->vertex == 1);
  sut.Depart(1, 0);
  const auto met = sut.NextArrival(4.0);  // robot 0 is still there
  CHECK(met->idleness_s == 0.0);
  sut.Depart(1, 1);
  sut.AdvanceTo(5.0);

  CHECK(sut.idleness_s(0) == 0.0);
  CHECK(sut.idleness_s(1) == 3.0);
  CHECK(sut.idleness_s(2) == 5.0);
  // ∫ over 5 s: 0 of vertex 0; 2²/2 + 3²/2 of vertex 1; 5²/2 of vertex 2.
  CHECK(sut.average_graph_idleness_s() == Approx((2.0 + 4.5 + 12.5) / (5.0 * 3)));
  CHECK(sut.NextArrival(6.0)->robot == 0);
  sut.Depart(0, 1);
  CHECK(sut.NextArrival(6.0)->robot == 1);
  sut.Depart(1, 0);
  sut.AdvanceTo(7.5);
  CHECK(sut.idleness_s(0) == 1.5);
}

TEST_CASE("A stay ends where the robot fails") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 1.0}, .stay_s = 100.0});
  sut.Reset(StandingOn({0, 2}), Rng(1));
  sut.Schedule(std::vector<RobotChange>{{.time_s = 2.5, .robot = 0}});
  sut.NextArrival(0.0);
  sut.Depart(0, 0);
  sut.NextArrival(0.0);
  sut.Depart(1, 1);
  sut.NextArrival(3.0);

  CHECK(sut.time_s() == 3.0);
  CHECK(sut.idleness_s(0) == 0.5);
}

TEST_CASE("Idleness counts by the vertices' priorities") {
  GraphData data = Path().data();
  data.priorities = {1.0, 4.0, 1.0};  // weights 0.5, 2, 0.5
  const PatrolGraph graph(data);
  PatrolWorld sut(graph, {.speeds_mps = {1.0}});
  sut.Reset(StandingOn({0}), Rng(1));
  sut.NextArrival(0.0);
  sut.Depart(0, 1);
  const auto arrival = sut.NextArrival(2.0);
  sut.Depart(0, 2);
  sut.AdvanceTo(4.0);

  CHECK(arrival->idleness_s == 4.0);
  CHECK(sut.idleness_s(2) == 2.0);
  CHECK(sut.instantaneous_graph_idleness_s() == Approx((0.5 * 4 + 2 * 2 + 0.5 * 4) / 3));
  CHECK(sut.worst_idleness_s() == 4.0);
  CHECK(sut.average_graph_idleness_s() == Approx((0.5 * 8 + 2 * (2 + 2) + 0.5 * 8) / (4.0 * 3)));
}

TEST_CASE("What is announced has no noise, what happens has") {
  const PatrolGraph graph = Path();
  PatrolWorld sut(graph, {.speeds_mps = {1.0}, .travel_noise = 0.5});
  sut.Reset(StandingOn({0}), Rng(1));
  sut.NextArrival(0.0);
  sut.Depart(0, 1);

  CHECK(sut.expected_arrivals_s()[0] == 2.0);
  CHECK(sut.arrival_s(0) != 2.0);
}

TEST_CASE("A robot on an edge is where its time has brought it") {
  GraphData data = Path().data();
  data.positions = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}};
  const PatrolGraph graph(data);
  PatrolWorld sut(graph, {.speeds_mps = {1.0, 0.5}});
  sut.Reset(StandingOn({0, 2}), Rng(1));
  sut.NextArrival(0.0);
  sut.Depart(0, 1);
  sut.NextArrival(0.0);
  sut.Depart(1, 1);
  sut.AdvanceTo(1.5);

  CHECK(sut.position(0).x_m == Approx(1.5));
  CHECK(sut.position(1).y_m == Approx(2.25));
}

TEST_CASE("A stay that is no time is refused") {
  const PatrolGraph graph = Path();
  CHECK_THROWS_AS(PatrolWorld(graph, {.speeds_mps = {1.0}, .stay_s = -1.0}), InputError);
}

}  // namespace
}  // namespace ronda
