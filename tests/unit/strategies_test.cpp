#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "common/base/error.h"
#include "common/world/closed_walk.h"
#include "common/world/strategies/gbs.h"
#include "common/world/strategies/random_argmax.h"
#include "common/world/strategies/sebs.h"
#include "common/world/strategies/strategy.h"
#include "tests/unit/graphs_by_hand.h"
#include "tests/unit/played_team.h"

namespace ronda {
namespace {

using testing::GraphOf;
using testing::PlayedTeam;
using testing::StandingOn;
using testing::Star;

/// A graph, and a strategy with all that it may need.
struct Setting {
  PatrolGraph graph;
  ShortestPaths paths{graph};
  ClosedWalk walk = ClosedWalkOf(graph, paths);

  std::unique_ptr<Strategy> Make(const std::string& name) const {
    return MakeStrategy(name, {.graph = &graph, .paths = &paths, .closed_walk = &walk});
  }
};

TEST_CASE("Equal best scores are chosen equally often, also when rounding sets them apart") {
  // χ² with 2 degrees of freedom exceeds 18.4 once in 10000.
  Rng rng = SplitSeed(1, 0);
  std::map<int, int> count;
  for (int i = 0; i < 9'000; ++i) {
    RandomArgmax sut(rng);
    sut.Offer(0, 0.5);
    sut.Offer(1, 0.3);
    sut.Offer(2, 0.1 + 0.4 + 1e-16);
    sut.Offer(3, 0.5 - 1e-13);
    ++count[sut.best()];
  }

  CHECK(count.count(1) == 0);
  double chi_square = 0.0;
  for (const int candidate : {0, 2, 3}) {
    chi_square += std::pow(count[candidate] - 3000.0, 2) / 3000.0;
  }
  CHECK(chi_square < 18.4);
}

TEST_CASE("The best wins over an earlier tie, and negative scores order as numbers do") {
  Rng rng = SplitSeed(1, 0);
  RandomArgmax sut(rng);
  CHECK(sut.best() == -1);
  sut.Offer(4, -2.0);
  sut.Offer(5, -2.0);
  sut.Offer(6, -1.0);
  sut.Offer(7, -1.5);
  CHECK(sut.best() == 6);
}

TEST_CASE("SEBS: gain and exchange factor are the published formulas") {
  CHECK(BayesianGainProbability(0.0, 10.0) == Approx(0.1));
  CHECK(BayesianGainProbability(500.0, 10.0) == Approx(std::sqrt(0.1)));
  CHECK(BayesianGainProbability(1000.0, 10.0) == 1.0);
  CHECK(BayesianGainProbability(5000.0, 10.0) == 1.0);
  CHECK(BayesianGainProbability(50.0, 0.001) == Approx(std::sqrt(0.1)));  // c is at least e_min
  CHECK(StateExchangeFactor(0, 4) == 1.0);
  CHECK(StateExchangeFactor(1, 4) == Approx(8.0 / 15.0));
  CHECK(StateExchangeFactor(3, 4) == Approx(2.0 / 15.0));
  CHECK(StateExchangeFactor(1, 10'000) == Approx(0.5));
}

TEST_CASE("CR goes by the robot's own visits, blind to its teammate's") {
  // Robot 0 was at leaf 1, robot 1 at leaf 2; to robot 0 the leaves 2 and 3 are equally idle.
  const Setting setting{Star(3)};
  const auto sut = setting.Make("cr");
  PlayedTeam team(setting.graph, *sut, {1.0, 1.0}, 2);
  std::map<int, int> count;
  for (int i = 0; i < 200; ++i) {
    team.StartFrom(StandingOn({0, 0}));
    team.DecideThenGo(1);  // t = 0: robot 0 …
    team.DecideThenGo(2);  // … and robot 1
    team.DecideThenGo(0);  // t = 1
    team.DecideThenGo(0);
    ++count[team.DecideThenGo(1)];  // t = 2: robot 0
  }

  CHECK(count[1] == 0);
  CHECK(count[2] > 60);  // 5.6 standard deviations below a half
  CHECK(count[3] > 60);
}

TEST_CASE("CR prefers the neighbour that it left longest ago") {
  const Setting setting{Star(3)};
  const auto sut = setting.Make("cr");
  PlayedTeam team(setting.graph, *sut, {1.0}, 2);
  team.StartFrom(StandingOn({0}));

  std::vector<int> leaves;
  for (int i = 0; i < 12; ++i) {
    const int next = team.DecideNext();
    if (next != 0) leaves.push_back(next);
  }

  REQUIRE(leaves.size() == 6);
  CHECK(leaves[0] != leaves[1]);
  CHECK(leaves[1] != leaves[2]);
  CHECK(leaves[0] != leaves[2]);
  for (int i = 3; i < 6; ++i) CHECK(leaves[i] == leaves[i - 3]);
}

/// Robot 0 arrives at the junction 0 at t = 2; the leaves 1, 2, 3 are 1, 4 and 9 m away.
TEST_CASE("SEBS, ER and GEI score neighbours by idleness, length and what others announced") {
  const Setting setting{GraphOf(4, {{0, 1, 1.0}, {0, 2, 4.0}, {0, 3, 9.0}})};
  Rng rng = SplitSeed(4, 0);
  const auto choice = [&](const std::string& name, int other_target) {
    const auto sut = setting.Make(name);
    PatrolWorld world(setting.graph, {.speeds_mps = {1.0, 1.0}});
    // Robot 0 starts 2 m before the junction; robot 1 stands there and leaves for `other_target`.
    world.Reset(std::vector<RobotStart>{{.vertex = 2, .next = 0, .remaining_m = 2.0},
                                        {.vertex = 0, .next = 0}},
                Rng(1));
    const auto first = world.NextArrival(0.0);
    REQUIRE(first);
    world.Depart(1, other_target);
    auto arrival = world.NextArrival(2.0);
    while (arrival && arrival->robot == 1) {
      world.Depart(1, 0);  // back to the junction
      arrival = world.NextArrival(2.0);
    }
    REQUIRE(arrival);
    return sut->Decide(CompleteBelief(world, arrival->robot), rng);
  };

  // Robot 1 heads to 3 (there at 9 s). Idleness 2 s everywhere.
  CHECK(choice("sebs", 3) == 1);   // G = 2, 1/2; 3 halved
  CHECK(choice("er", 3) == 1);     // 3/1, 6/4, |11 − 9|/9
  CHECK(choice("gei:0", 3) == 2);  // 3, 6, 0.05 · 2
  std::map<int, int> tie;          // gei:0.5: 3, 3, 0.05 · 2/3
  for (int i = 0; i < 100; ++i) ++tie[choice("gei:0.5", 3)];
  CHECK(tie[1] > 20);
  CHECK(tie[1] + tie[2] == 100);
  CHECK(tie[2] > 20);
  CHECK(choice("gei:1", 3) == 1);  // 3, 1.5
  // Robot 1 heads to 2 (there at 4 s).
  CHECK(choice("er", 2) == 1);       // 3/1, |6 − 4|/4, 11/9
  CHECK(choice("gei:0", 2) == 3);    // 3, 0.05 · 2, 11
  CHECK(choice("gei:0.5", 2) == 3);  // 3, …, 11/3
  // Robot 1 was at 1 at 1 s and is back at the junction at 2 s, after robot 0's decision.
  CHECK(choice("er", 1) == 1);       // 2/1, 6/4, 11/9
  CHECK(choice("sebs", 1) == 1);     // G = 1, 1/2, 2/9
  CHECK(choice("gei:0.5", 1) == 3);  // 2, 3, 11/3
}

TEST_CASE("Cyclic robots start evenly spaced, also on an edge, and visit every vertex in turn") {
  const Setting setting{GraphOf(
      4, {{0, 1, 40.0}, {0, 2, 25.0}, {0, 3, std::hypot(40.0, 25.0)}, {1, 3, 25.0}, {2, 3, 40.0}})};
  REQUIRE(setting.walk.length_m == Approx(130.0));
  const auto sut = setting.Make("cyclic");
  const std::vector<double> speeds_mps(4, 1.0);
  PatrolWorld world(setting.graph, {.speeds_mps = speeds_mps});
  Rng rng = SplitSeed(1, 0);

  const auto starts = sut->Begin(setting.graph, speeds_mps, rng);
  world.Reset(starts, Rng(1));
  int on_edge = 0;
  for (const RobotStart& start : starts) on_edge += static_cast<int>(start.remaining_m > 0.0);
  const auto play = [&](double until_s) {
    while (const auto arrival = world.NextArrival(until_s)) {
      if (arrival->time_s > 130.0) CHECK(arrival->idleness_s == Approx(32.5));
      world.Depart(arrival->robot, sut->Decide(CompleteBelief(world, arrival->robot), rng));
    }
    world.AdvanceTo(until_s);
  };
  play(130.0);
  world.BeginMeasurement();
  play(130.0 + 32.5 * 20);

  CHECK(on_edge == 2);
  CHECK(world.average_graph_idleness_s() == Approx(16.25));
  CHECK(world.worst_idleness_s() == Approx(32.5));
}

TEST_CASE("Every name of the list makes a strategy that names a neighbour") {
  const Setting setting{Star(4)};
  const std::vector<double> speeds_mps(6, 1.0);  // more robots than vertices
  for (const std::string& name : AllStrategyNames()) {
    CAPTURE(name);
    const auto sut = setting.Make(name);
    PlayedTeam team(setting.graph, *sut, speeds_mps, 8, 0.1);
    for (int i = 0; i < 500; ++i) team.DecideNext();  // Depart refuses anything else
    CHECK(team.world.instantaneous_worst_idleness_s() < 500.0);
  }
}

/// Where robot 0 goes while its teammates walk at random.
std::vector<int> WaysOfFirst(const PatrolGraph& graph, Strategy& strategy,
                             std::uint64_t teammates_seed) {
  PatrolWorld world(graph, {.speeds_mps = {1.0, 0.7, 1.3}});
  TeamBeliefs beliefs(graph, 3, strategy.knowledge(), {});
  beliefs.OnHeard([&](int receiver, int sender) { strategy.Hear(receiver, sender); });
  Rng own(5);
  Rng others(teammates_seed);
  world.Reset(strategy.Begin(graph, world.speeds_mps(), own), Rng(1));
  beliefs.Begin(world, Rng(1));
  std::vector<int> went;
  while (went.size() < 300) {
    const auto arrival = world.NextArrival(kNever_s);
    const Belief belief = beliefs.Arrived(world, *arrival);
    const auto neighbours = graph.neighbours(arrival->vertex);
    if (arrival->robot == 0) {
      went.push_back(strategy.Decide(belief, own));
      world.Depart(0, went.back());
    } else {
      world.Depart(arrival->robot,
                   neighbours[others.Below(static_cast<std::uint32_t>(neighbours.size()))]);
    }
    beliefs.Departed(world, arrival->robot);
  }
  return went;
}

TEST_CASE("A robot's way depends on its teammates only where it is told of their visits") {
  const Setting setting{GraphOf(
      6,
      {{0, 1, 3.0}, {1, 2, 4.0}, {2, 3, 5.0}, {3, 4, 2.5}, {4, 5, 3.5}, {5, 0, 6.0}, {1, 4, 4.5}})};
  int told = 0;
  for (const StrategyInfo& info : KnownStrategies()) {
    CAPTURE(info.name);
    const auto sut = setting.Make(std::string(info.name));
    const bool shares = sut->knowledge().visits == Knowledge::Visits::kShared;
    told += static_cast<int>(shares);
    const bool same = WaysOfFirst(setting.graph, *sut, 1) == WaysOfFirst(setting.graph, *sut, 2);
    CHECK(same == !shares);
    CHECK(shares == info.knowledge.starts_with("all visits"));
  }
  CHECK(told == 12);
}

TEST_CASE("Every strategy patrols under all conditions at once") {
  const Setting setting{GraphOf(
      6,
      {{0, 1, 3.0}, {1, 2, 4.0}, {2, 3, 5.0}, {3, 4, 2.5}, {4, 5, 3.5}, {5, 0, 6.0}, {1, 4, 4.5}})};
  const Communication communication{.message_loss = 0.3,
                                    .message_range_m = 8.0,
                                    .message_delay_s = 2.0,
                                    .observation_radius_m = 4.0};
  // Robot 3 joins late, the others fail one after another but for robot 0, and two are back.
  const std::vector<RobotChange> changes{{.time_s = 0.0, .robot = 3},
                                         {.time_s = 100.0, .robot = 3, .joins = true},
                                         {.time_s = 200.0, .robot = 1},
                                         {.time_s = 250.0, .robot = 2},
                                         {.time_s = 300.0, .robot = 3},
                                         {.time_s = 500.0, .robot = 1, .joins = true},
                                         {.time_s = 600.0, .robot = 2, .joins = true}};
  for (const StrategyInfo& info : KnownStrategies()) {
    CAPTURE(info.name);
    const auto sut = setting.Make(std::string(info.name));
    PatrolWorld world(setting.graph,
                      {.speeds_mps = {1.0, 0.7, 1.3, 1.0}, .travel_noise = 0.3, .stay_s = 2.0});
    TeamBeliefs beliefs(setting.graph, 4, sut->knowledge(), communication);
    beliefs.OnHeard([&](int receiver, int sender) { sut->Hear(receiver, sender); });
    Rng rng(7);
    world.Reset(sut->Begin(setting.graph, world.speeds_mps(), rng), Rng(8));
    world.Schedule(changes);
    beliefs.Begin(world, Rng(9));
    std::vector<int> decisions(4, 0);
    while (const auto arrival = PlayNext(world, beliefs, *sut, 1000.0, rng)) {
      ++decisions[arrival->robot];
    }
    world.AdvanceTo(1000.0);
    for (const int count : decisions) CHECK(count > 20);
    if (info.name != "gbs" && info.name != "cr:shared" && info.name != "hcr:shared") {
      CHECK(world.instantaneous_worst_idleness_s() < 400.0);
    }
  }
}

TEST_CASE("A strategy that does not exist, or a bad exponent, is refused with what there is") {
  const Setting setting{Star(3)};

  CHECK_THROWS_WITH(setting.Make("sebz"), Catch::Contains("'sebz'") && Catch::Contains("sebs"));
  for (const char* name : {"gei:", "gei:-1", "gei:x", "gei:1x", "gei:inf", "gei:nan", "GEI", ""}) {
    CAPTURE(name);
    CHECK_THROWS_AS(setting.Make(name), UsageError);
  }
}

}  // namespace
}  // namespace ronda
