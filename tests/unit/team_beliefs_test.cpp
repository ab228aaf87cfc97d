#include "common/world/team_beliefs.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "common/world/closed_walk.h"
#include "common/world/strategies/strategy.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

using testing::GraphOf;
using testing::StandingOn;
using testing::Star;

constexpr Knowledge kOwn{.visits = Knowledge::Visits::kOwn};
constexpr Knowledge kAll{.visits = Knowledge::Visits::kShared, .intentions = true};

/// 0 – 1 – 2 – 3 – 4, 10 m apart on a line.
PatrolGraph Line() {
  GraphData data;
  data.name = "line";
  for (int v = 0; v < 5; ++v) {
    data.vertex_ids.push_back(std::to_string(v));
    data.positions.push_back({.x_m = 10.0 * v, .y_m = 0.0});
    if (v > 0) data.edges.push_back({v - 1, v, 10.0});
  }
  return PatrolGraph(data);
}

/// Robots that go where the test says; robot by robot as they arrive.
class Scene {
 public:
  Scene(const PatrolGraph& graph, const std::vector<int>& starts, const Knowledge& knowledge,
        const Communication& communication, double stay_s = 0.0)
      : world(graph, {.speeds_mps = std::vector<double>(starts.size(), 1.0), .stay_s = stay_s}),
        beliefs(graph, static_cast<int>(starts.size()), knowledge, communication) {
    world.Reset(StandingOn(starts), Rng(1));
    beliefs.Begin(world, Rng(7));
  }

  /// What the next robot knows; then it goes to `next`.
  Belief Go(int next) {
    const Belief belief = Look();
    Depart(belief.robot, next);
    return belief;
  }
  Belief Look() {
    const auto arrival = world.NextArrival(kNever_s);
    REQUIRE(arrival);
    return beliefs.Arrived(world, *arrival);
  }
  void Depart(int robot, int next) {
    world.Depart(robot, next);
    beliefs.Departed(world, robot);
  }

  PatrolWorld world;
  TeamBeliefs beliefs;
};

TEST_CASE("A robot that knows its own visits gets those and nothing else") {
  const PatrolGraph graph = Star(3);
  Scene scene(graph, {0, 0}, kOwn, {});

  scene.Go(1);                      // t = 0: robot 0
  scene.Go(2);                      //        robot 1
  scene.Go(0);                      // t = 1: robot 0 at 1
  scene.Go(0);                      //        robot 1 at 2
  const Belief sut = scene.Look();  // t = 2: robot 0 back at 0

  CHECK(sut.robot == 0);
  CHECK(sut.vertex == 0);
  CHECK(sut.last_visit_s(1) == 1.0);
  CHECK(sut.last_visit_s(2) == 0.0);  // the world's is 1
  CHECK(scene.world.last_visit_s(2) == 1.0);
  CHECK(sut.targets.empty());
  CHECK(sut.expected_arrivals_s.empty());
  CHECK(sut.previous_vertices.empty());
}

TEST_CASE("A robot that knows nothing gets no visits") {
  const PatrolGraph graph = Star(3);
  Scene scene(graph, {0, 0}, {}, {});

  CHECK(scene.Look().last_visits_s.empty());
}

TEST_CASE("With complete communication everyone has the world's own arrays") {
  const PatrolGraph graph = Star(3);
  Scene scene(graph, {0, 0}, kAll, {});

  scene.Go(1);
  const Belief sut = scene.Look();

  CHECK(sut.last_visits_s.data() == scene.world.last_visits_s().data());
  CHECK(sut.target(0) == 1);
  CHECK(sut.arrival_s(0) == 1.0);
  CHECK(sut.claims(1) == 1);
  CHECK_FALSE(sut.claimed(2));
}

TEST_CASE("Messages that all arrive at once are complete communication") {
  // The long way through rows of beliefs, against the world's arrays: decision by decision.
  const PatrolGraph graph = GraphOf(
      6,
      {{0, 1, 3.0}, {1, 2, 4.0}, {2, 3, 5.0}, {3, 4, 2.5}, {4, 5, 3.5}, {5, 0, 6.0}, {1, 4, 4.5}});
  const ShortestPaths paths(graph);
  const ClosedWalk walk = ClosedWalkOf(graph, paths);
  for (const char* name : {"sebs", "er", "gei", "gbs", "cbls", "dtag", "dtap"}) {
    const auto strategy =
        MakeStrategy(name, {.graph = &graph, .paths = &paths, .closed_walk = &walk});
    const auto play = [&](const Communication& communication) {
      PatrolWorld world(graph, {.speeds_mps = {1.0, 0.7, 1.3}, .stay_s = 0.0});
      TeamBeliefs beliefs(graph, 3, strategy->knowledge(), communication);
      beliefs.OnHeard([&](int receiver, int sender) { strategy->Hear(receiver, sender); });
      Rng rng(3);
      world.Reset(strategy->Begin(graph, world.speeds_mps(), rng), Rng(1));
      beliefs.Begin(world, Rng(7));
      std::vector<int> went;
      for (int i = 0; i < 2000; ++i) {
        const auto arrival = PlayNext(world, beliefs, *strategy, kNever_s, rng);
        went.push_back(world.target(arrival->robot));
      }
      return went;
    };
    CAPTURE(name);
    CHECK(play({.message_range_m = 1e9}) == play({}));
    CHECK(play({.message_loss = 0.5}) != play({}));
  }
}

TEST_CASE("A lost message is not heard, and its sender's way is unknown once its news are old") {
  const PatrolGraph graph = Star(3);
  Scene scene(graph, {0, 0}, kAll, {.message_loss = 1.0});

  const Belief first = scene.Go(1);  // t = 0: robot 0; it knows where robot 1 starts
  CHECK(first.target(1) == 0);
  scene.Go(2);
  const Belief sut = scene.Go(0);  // t = 1: robot 0 at leaf 1

  CHECK(sut.target(1) == -1);
  CHECK(sut.last_visit_s(2) == 0.0);
  CHECK(sut.last_visit_s(1) == 1.0);
}

TEST_CASE("A message tells visit, target and arrival; an arrival whose time has come is a visit") {
  const PatrolGraph graph = GraphOf(4, {{0, 1, 1.0}, {0, 2, 2.5}, {0, 3, 4.0}});
  Scene scene(graph, {0, 0}, kAll, {.message_range_m = 1e9});

  scene.Go(1);                         // t = 0: robot 0, there at 1
  scene.Go(2);                         // t = 0: robot 1, there at 2.5
  const Belief at_leaf = scene.Go(0);  // t = 1: robot 0
  CHECK(at_leaf.target(1) == 2);
  CHECK(at_leaf.arrival_s(1) == 2.5);
  CHECK(at_leaf.previous_vertices[1] == 0);
  scene.Go(3);                          // t = 2: robot 0 goes to 3, there at 6
  scene.Go(0);                          // t = 2.5: robot 1 back to 0, there at 5
  const Belief robot_1 = scene.Look();  // t = 5: robot 1 at 0
  CHECK(robot_1.robot == 1);
  CHECK(robot_1.target(0) == 3);
  CHECK(robot_1.last_visit_s(1) == 1.0);  // heard when robot 0 left it
  scene.Depart(1, 1);                     // there at 6
  const Belief robot_0 = scene.Look();    // t = 6: robot 0 first, then 1
  CHECK(robot_0.target(1) == 1);
  CHECK(robot_0.last_visit_s(2) == 2.5);
}

TEST_CASE("An announced arrival whose time has come counts as a visit") {
  const PatrolGraph graph = Line();
  // Robot 1 is heard when it leaves 2 for 3, and is out of range afterwards.
  Scene scene(graph, {1, 2}, kAll, {.message_range_m = 12.0});

  scene.Go(0);                        // t = 0: robot 0 to vertex 0
  scene.Go(3);                        // t = 0: robot 1 to vertex 3
  const Belief before = scene.Go(1);  // t = 10: robot 0 at 0
  CHECK(before.target(1) == 3);       // due just now
  scene.Go(4);                        // t = 10: robot 1, 30 m away
  const Belief sut = scene.Look();    // t = 20: robot 0 at 1
  CHECK(sut.target(1) == -1);
  CHECK(sut.last_visit_s(3) == 10.0);
  CHECK(sut.last_visit_s(4) == 0.0);
}

TEST_CASE("Who is out of range does not hear, who is within hears") {
  const PatrolGraph graph = Line();
  Scene scene(graph, {0, 1, 4}, kAll, {.message_range_m = 15.0});

  scene.Go(1);                      // robot 0
  const Belief near = scene.Go(2);  // robot 1
  const Belief far = scene.Look();  // robot 2

  CHECK(near.target(0) == 1);
  CHECK(far.target(0) == 0);  // where it started
  CHECK(far.target(1) == 1);
}

TEST_CASE("A delayed message is heard when its time has come") {
  const PatrolGraph graph = Line();
  Scene scene(graph, {0, 4}, kAll, {.message_delay_s = 15.0});

  scene.Go(1);                                // t = 0: robot 0
  scene.Go(3);                                // t = 0: robot 1
  CHECK(scene.Go(2).last_visit_s(3) == 0.0);  // t = 10: robot 0 at 1
  scene.Go(4);                                // t = 10: robot 1 at 3, says so
  const Belief at_20 = scene.Go(1);           // t = 20: robot 0 at 2; heard of t = 0 at t = 15
  CHECK(at_20.last_visit_s(3) == 10.0);       // announced for then
  CHECK(at_20.target(1) == -1);
  scene.Go(3);                        // t = 20: robot 1 at 4
  const Belief at_30 = scene.Look();  // t = 30: robot 0 at 1; heard of t = 10 at t = 25
  CHECK(at_30.last_visit_s(4) == 20.0);
}

TEST_CASE("A robot sees the truth within its radius, and beyond it keeps what it believed") {
  const PatrolGraph graph = Line();
  Scene scene(graph, {1, 3}, kAll, {.observation_radius_m = 20.0});

  const Belief first = scene.Go(0);  // t = 0: robot 0 at 1 sees 0 … 3 and robot 1 at 3
  CHECK(first.target(1) == 3);
  scene.Go(4);                        // robot 1
  const Belief at_0 = scene.Go(1);    // t = 10: robot 0 at 0 sees 0, 1, 2
  CHECK(at_0.target(1) == -1);        // 40 m away, and the team is silent
  scene.Go(3);                        // t = 10: robot 1 at 4
  const Belief sut = scene.Look();    // t = 20: robot 0 at 1; robot 1 is at 3, 20 m away
  CHECK(sut.last_visit_s(4) == 0.0);  // not seen
  CHECK(sut.target(1) == 3);
  CHECK(sut.last_visit_s(3) == scene.world.last_visit_s(3));
}

TEST_CASE("A radius with an option of messages does not silence the team") {
  CHECK(Communication{.observation_radius_m = 5.0}.loss() == 1.0);
  CHECK(Communication{.message_range_m = 9.0, .observation_radius_m = 5.0}.loss() == 0.0);
  CHECK(Communication{.message_loss = 0.0, .observation_radius_m = 5.0}.complete());
  CHECK(Communication{}.complete());
  CHECK_FALSE(Communication{.message_delay_s = 1.0}.complete());
}

TEST_CASE("Messages are lost at the rate that is asked for, independently of each other") {
  // 4000 messages to each of two others; each count lies within 5 standard deviations of 1200.
  const PatrolGraph graph = Star(3);
  std::vector<int> heard(3, 0);
  int both = 0;
  Scene scene(graph, {0, 0, 0}, {.visits = Knowledge::Visits::kOwn, .messages = true},
              {.message_loss = 0.7});
  std::set<int> receivers;
  scene.beliefs.OnHeard([&](int receiver, int sender) {
    CHECK(sender == 0);
    ++heard[receiver];
    receivers.insert(receiver);
  });
  for (int i = 0; i < 4000; ++i) {
    scene.world.Reset(StandingOn({0, 0, 0}), Rng(1));
    receivers.clear();
    scene.Go(1);
    both += static_cast<int>(receivers.size() == 2);
  }
  CHECK(heard[0] == 0);
  CHECK(std::abs(heard[1] - 1200) < 145);
  CHECK(std::abs(heard[2] - 1200) < 145);
  CHECK(std::abs(both - 360) < 91);  // 0.3² of 4000, 5 standard deviations of 18
}

TEST_CASE("Nothing is known of a robot that has failed but that") {
  const PatrolGraph graph = Star(3);
  for (const double range_m : {0.0, 1e9}) {
    Scene scene(graph, {0, 0}, kAll,
                range_m > 0.0 ? Communication{.message_range_m = range_m} : Communication{});
    scene.world.Schedule(std::vector<RobotChange>{{.time_s = 0.5, .robot = 1}});
    scene.Go(1);
    scene.Go(2);
    const Belief sut = scene.Look();  // t = 1
    CHECK(sut.robot == 0);
    CHECK(sut.on_patrol[1] == 0);
    CHECK(sut.team_size() == 1);
    CHECK(sut.target(1) == -1);
    CHECK(sut.last_visit_s(2) == 0.0);
  }
}

TEST_CASE("A stay is known as one, whoever knows of it") {
  const PatrolGraph graph = Star(3);
  for (const Communication& communication :
       {Communication{}, Communication{.message_range_m = 1e9}}) {
    Scene scene(graph, {0, 1}, kAll, communication, 5.0);
    scene.Go(2);                      // t = 0: robot 0, there at 1
    scene.Go(1);                      // t = 0: robot 1 stays at leaf 1 until 5
    const Belief sut = scene.Look();  // t = 1: robot 0
    CHECK(sut.idleness_s(1) == 0.0);
    CHECK(sut.idleness_s(1, 7.0) == 2.0);
    CHECK(sut.target(1) == 1);
  }
}

}  // namespace
}  // namespace ronda
