#include "common/world/conditions.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/world/conditions_text.h"
#include "tests/unit/graphs_by_hand.h"

namespace ronda {
namespace {

using Catch::Contains;

Conditions Of(const std::vector<std::pair<std::string, std::string>>& texts) {
  Conditions conditions;
  for (const auto& [name, text] : texts) SetCondition(conditions, name, text);
  return conditions;
}

TEST_CASE("Each condition is set by its text, and a label says what differs from the defaults") {
  CHECK(Label({}).empty());
  const Conditions sut = Of({{"speed", "1/0.5"},
                             {"noise", "0.1"},
                             {"message-loss", "0.5"},
                             {"message-range", "20"},
                             {"message-delay", "2"},
                             {"observation-radius", "15"},
                             {"fail", "3@600/1@300"},
                             {"join", "1@900"},
                             {"priority", "12=5/hall=0.5"},
                             {"stay", "10"}});

  CHECK(sut.speeds_mps == std::vector<double>{1.0, 0.5});
  CHECK(sut.travel_noise == 0.1);
  CHECK(sut.communication.message_loss == 0.5);
  CHECK(sut.communication.message_range_m == 20.0);
  CHECK(sut.communication.message_delay_s == 2.0);
  CHECK(sut.communication.observation_radius_m == 15.0);
  CHECK(sut.attrition.changes.size() == 3);
  CHECK(sut.priorities == std::vector<std::pair<std::string, double>>{{"12", 5.0}, {"hall", 0.5}});
  CHECK(sut.stay_s == 10.0);
  CHECK(Label(sut) ==
        "speed 1/0.5 m/s, noise 0.1, loss 0.5, range 20 m, delay 2 s, radius 15 m, fail 1@300 s, "
        "fail 3@600 s, join 1@900 s, priority 12=5, priority hall=0.5, stay 10 s");
  CHECK(Label(Of({{"mean-time-to-failure", "600"}, {"repair", "60"}})) ==
        "failures each 600 s, repair 60 s");
}

TEST_CASE("none is the default of every condition") {
  Conditions sut;
  for (const ConditionOption& option : ConditionOptions()) SetCondition(sut, option.name, "none");
  CHECK(sut == Conditions());
}

TEST_CASE("A text that is no value names condition, rule and text") {
  CHECK_THROWS_WITH(Of({{"noise", "x"}}), "noise: must be a number, got 'x'");
  CHECK_THROWS_WITH(Of({{"speed", "1/"}}), "speed: must be a number, got ''");
  CHECK_THROWS_WITH(Of({{"fail", "3"}}), "fail: must be ROBOT@SECONDS, got '3'");
  CHECK_THROWS_WITH(Of({{"join", "x@3"}}), "join: must be a number, got 'x'");
  CHECK_THROWS_WITH(Of({{"priority", "=3"}}), "priority: must be VERTEX=PRIORITY, got '=3'");
}

TEST_CASE("A condition out of its range names rule and value") {
  const auto check = [](const std::vector<std::pair<std::string, std::string>>& texts,
                        const std::string& message) {
    CHECK_THROWS_WITH(CheckConditions(Of(texts), 3), Contains(message));
  };
  check({{"speed", "0"}}, "speed must be > 0 m/s and finite, got 0");
  check({{"noise", "-1"}}, "noise must be ≥ 0 and finite, got -1");
  check({{"noise", "nan"}}, "noise must be ≥ 0 and finite, got nan");
  check({{"message-loss", "1.5"}}, "message loss must be in 0 … 1, got 1.5");
  check({{"message-range", "0"}}, "message range must be > 0 m and finite, got 0");
  check({{"message-delay", "inf"}}, "message delay must be ≥ 0 s and finite, got inf");
  check({{"observation-radius", "-2"}}, "observation radius must be ≥ 0 m and finite, got -2");
  check({{"mean-time-to-failure", "0.5"}}, "mean time to failure must be ≥ 1 s and finite");
  check({{"repair", "60"}}, "a repair time needs a mean time to failure");
  check({{"mean-time-to-failure", "60"}, {"fail", "1@3"}}, "not both");
  check({{"fail", "3@60"}}, "must be in 0 … 2, got 3");
  check({{"fail", "1@0"}}, "the time of a failure must be > 0 s and finite, got 0");
  check({{"fail", "1@5/1@9"}}, "robot 1 fails at 9 s, but it is not there then");
  check({{"fail", "0@9"}, {"join", "0@5/0@12/0@13"}}, "robot 0 joins at 13 s, but it is already");
  check({{"fail", "0@5/1@5/2@5"}}, "robot 2 fails at 5 s, but it is the last one there");
  check({{"join", "0@5/1@5/2@5"}}, "at least one robot must be there from the beginning");
  check({{"stay", "-1"}}, "stay must be ≥ 0 s and finite, got -1");
  CHECK_NOTHROW(CheckConditions(Of({{"join", "1@5"}, {"fail", "0@9/1@12"}}), 3));
}

TEST_CASE("The robots take the speeds in turn") {
  CHECK(SpeedsOf(Of({{"speed", "1/0.5"}}), 3) == std::vector<double>{1.0, 0.5, 1.0});
  CHECK(TotalSpeed_mps(Of({{"speed", "1/0.5"}}), 3) == 2.5);
}

TEST_CASE("Given changes come in the order of their times") {
  const auto sut =
      DrawChanges(Of({{"fail", "2@9/1@3"}, {"join", "0@5"}}).attrition, 3, 100.0, Rng(1));

  REQUIRE(sut.size() == 3);
  CHECK(sut[0] == RobotChange{.time_s = 3.0, .robot = 1});
  CHECK(sut[1] == RobotChange{.time_s = 5.0, .robot = 0, .joins = true});
  CHECK(sut[2] == RobotChange{.time_s = 9.0, .robot = 2});
}

TEST_CASE("Random failures come at the rate asked for, and never take the last robot") {
  // 200 robots, mean 100 s, repaired after 100 s: over 20 000 s each has about 100 failures (a
  // cycle of 200 s; sd of a cycle 100 s, so sd 5 a robot, 71 in all). 5 standard deviations.
  const Attrition attrition{.mean_time_to_failure_s = 100.0, .repair_s = 100.0};
  const auto many = DrawChanges(attrition, 200, 20'000.0, Rng(5));
  int failures = 0;
  for (const RobotChange& change : many) failures += change.joins ? 0 : 1;
  CHECK(std::abs(failures - 20'000) < 450);

  const Attrition for_good{.mean_time_to_failure_s = 10.0};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    CHECK(DrawChanges(for_good, 4, 10'000.0, Rng(seed)).size() == 3);
  }
  CHECK(DrawChanges(for_good, 1, 10'000.0, Rng(1)).empty());
}

TEST_CASE(
    "Drawn changes are a possible schedule: times ascend, who is there fails, who is not joins") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto sut =
        DrawChanges({.mean_time_to_failure_s = 50.0, .repair_s = 30.0}, 3, 2'000.0, Rng(seed));
    std::vector<bool> there(3, true);
    double last_s = 0.0;
    for (const RobotChange& change : sut) {
      REQUIRE(change.time_s >= last_s);
      REQUIRE(change.time_s < 2'000.0);
      REQUIRE(there[change.robot] != change.joins);
      there[change.robot] = change.joins;
      REQUIRE((there[0] || there[1] || there[2]));
      last_s = change.time_s;
    }
    CHECK(sut.size() > 20);
  }
}

TEST_CASE("Priorities of the conditions take the place of the map's") {
  const PatrolGraph graph = testing::Path();
  const PatrolGraph sut = WithPriorities(graph, Of({{"priority", "1=4"}}));

  CHECK(sut.weights()[1] == 2.0);
  CHECK(sut.weights()[0] == 0.5);
  CHECK(WithPriorities(graph, {}).unweighted());
  CHECK_THROWS_WITH(WithPriorities(graph, Of({{"priority", "9=4"}})),
                    Contains("map by hand has no vertex 9"));
  CHECK_THROWS_WITH(WithPriorities(graph, Of({{"priority", "1=0"}})),
                    Contains("priority of vertex 1 must be in 1e-6 … 1e6, got 0"));
}

}  // namespace
}  // namespace ronda
