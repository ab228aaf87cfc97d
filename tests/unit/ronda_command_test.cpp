// The front command as a user meets it: exit status, one sentence on stderr, nothing half-written.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/temporary_folder.h"
#include "tests/unit/ronda_program.h"

namespace ronda {
namespace {

using testing::Ronda;

std::string Evaluate(const std::string& arguments) {
  return "evaluate --map " RONDA_SOURCE_DIR "/maps/4nodes.json " + arguments;
}

TEST_CASE("evaluate prints what it measured, and writes JSON and trace") {
  const TemporaryFolder folder;
  const auto json_path = (folder.path() / "r.json").string();
  const auto trace_path = (folder.path() / "t.csv").string();

  const auto result = Ronda(Evaluate("--agents 7 --strategy sebs --episodes 2 --json " + json_path +
                                     " --trace " + trace_path));

  CHECK(result.status == 0);
  CHECK_THAT(result.output, Catch::Contains("7 robots") && Catch::Contains("lower bound"));
  std::ifstream file(json_path);
  const auto json = nlohmann::json::parse(file);
  CHECK(json["map"] == RONDA_SOURCE_DIR "/maps/4nodes.json");
  CHECK(json["agents"] == 7);
  CHECK(json["episodes"] == 2);
  CHECK(json["agi_s"]["mean"].get<double>() > json["lower_bound_agi_s"].get<double>() * 0.98);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()),
                      std::filesystem::directory_iterator()) == 2);
}

TEST_CASE("compare puts all strategies into one table and one list") {
  const TemporaryFolder folder;
  const auto json_path = (folder.path() / "r.json").string();

  const auto result = Ronda("compare --map " RONDA_SOURCE_DIR
                            "/maps/grid.json --agents 2 --strategies all --protocol thesis "
                            "--horizon 200 --episodes 3 --json " +
                            json_path);

  CHECK(result.status == 0);
  CHECK_THAT(result.output, Catch::Contains("horizon 200 s") && Catch::Contains("gei ") &&
                                Catch::Contains("Best classical"));
  std::ifstream file(json_path);
  const auto json = nlohmann::json::parse(file);
  REQUIRE(json.size() == 13);
  CHECK(json[0]["strategy"] == "random");
  CHECK(json[0]["ratio_to_random"] == 1.0);
  CHECK(json.back()["strategy"] == "ahpa");
}

TEST_CASE(
    "bounds prints what no team can beat, what proves it, and the closed walk from both sides") {
  const TemporaryFolder folder;
  const auto json_path = (folder.path() / "r.json").string();

  const auto result =
      Ronda("bounds --map cumberland --agents 10 --speed 0.075 --json " + json_path);

  CHECK(result.status == 0);
  CHECK_THAT(result.output, Catch::Contains("cumberland, 10 robots at 0.075 m/s") &&
                                Catch::Contains("132.96 s   rates of traversal") &&
                                Catch::Contains("318.25 s   covering linear programme") &&
                                Catch::Contains("at most") && Catch::Contains("373.31 m"));
  std::ifstream file(json_path);
  const auto json = nlohmann::json::parse(file);
  CHECK(json["map"] == "cumberland");
  CHECK(json["agents"] == 10);
  CHECK(json["speed_mps"] == 0.075);
  CHECK(json["lower_bound_agi_s"].get<double>() == Approx(132.96).epsilon(1e-4));
  CHECK(json["lower_bound_agi_method"] == "rates of traversal");
  CHECK(json["lower_bound_wi_s"].get<double>() == Approx(318.25).epsilon(1e-4));
  CHECK(json["lower_bound_wi_method"] == "covering linear programme");
  CHECK(json["shortest_closed_walk_m"].get<double>() == Approx(373.309).epsilon(1e-6));
  CHECK(json["shortest_closed_walk_lower_m"].get<double>() == Approx(373.309).epsilon(1e-4));
  CHECK(json["shortest_closed_walk_lower_method"] == "1-trees (Held and Karp)");
}

TEST_CASE("bounds follow the conditions: who may stay has lower ones") {
  const auto moving = Ronda("bounds --map 4nodes --agents 3");
  const auto staying = Ronda("bounds --map 4nodes --agents 3 --stay 5");
  CHECK_THAT(moving.output, Catch::Contains("16.67 s   shortest edge at each vertex"));
  CHECK_THAT(staying.output, Catch::Contains("stay 5 s") &&
                                 Catch::Contains("12.50 s   rates of traversal and shares"));
}

TEST_CASE("bounds of bad arguments: a sentence, a status, and no file") {
  struct Case {
    const char* arguments;
    int status;
    const char* says;
  };
  const TemporaryFolder folder;
  const auto json_path = (folder.path() / "r.json").string();
  for (const Case& bad :
       {Case{"--map grid", 2, "--agents"}, Case{"--agents 2", 2, "--map"},
        Case{"--map grid --agents 0", 2, "agents"}, Case{"--map grid --agents x", 2, "--agents"},
        Case{"--map grid --agents 2 --speed 0", 2, "speed must be > 0 m/s and finite, got 0"},
        Case{"--map grid --agents 2 --stay -1", 2, "stay must be"},
        Case{"--map grid --agents 2 --priority 99=2", 2, "no vertex 99"},
        Case{"--map grid --agents 2 --mean-time-to-failure 900 --repair 60", 2, "--repair"},
        Case{"--map grid --agents 2 --strategy cr", 2, "--strategy"},
        Case{"--map atlantis --agents 2", 3, "atlantis"}}) {
    CAPTURE(bad.arguments);
    const auto result = Ronda("bounds --json " + json_path + " " + bad.arguments);
    CHECK(result.status == bad.status);
    CHECK_THAT(result.output, Catch::Contains(bad.says));
    CHECK(std::filesystem::is_empty(folder.path()));
  }
  const auto unwritable = Ronda("bounds --map grid --agents 2 --json /nowhere/r.json");
  CHECK(unwritable.status == 2);
  CHECK_THAT(unwritable.output, Catch::Contains("/nowhere/r.json"));
}

TEST_CASE("strategies lists what there is, as a table and as JSON") {
  const TemporaryFolder folder;
  const auto json_path = (folder.path() / "s.json").string();

  const auto result = Ronda("strategies --json " + json_path);

  CHECK(result.status == 0);
  CHECK_THAT(result.output, Catch::Contains("cr:claims") && Catch::Contains("Yan & Zhang 2016"));
  std::ifstream file(json_path);
  const auto json = nlohmann::json::parse(file);
  CHECK(json.size() == 18);
  int in_all = 0;
  for (const auto& each : json) in_all += static_cast<int>(each["in_all"].get<bool>());
  CHECK(in_all == 13);
  CHECK(json[1]["name"] == "cr");
  CHECK(json[1]["knowledge"] == "own visits");
  CHECK_FALSE(json[1]["paper"].get<std::string>().empty());
  CHECK_FALSE(json[1]["rule"].get<std::string>().empty());
  CHECK(Ronda("strategies --json /nowhere/s.json").status == 2);
}

TEST_CASE("train --print-config prints what a run would have, and makes no run folder") {
  const TemporaryFolder folder;
  const auto run = (folder.path() / "run").string();

  const auto result =
      Ronda("train --map 4nodes --agents 3 --set dqn.batch_size=64 --print-config --run " + run);

  CHECK(result.status == 0);
  CHECK_THAT(result.output, Catch::Contains("agents = 3\n") &&
                                Catch::Contains("batch_size = 64\n") &&
                                Catch::Contains("schema = \"patrol-candidates-26\"\n"));
  CHECK_FALSE(std::filesystem::exists(run));
}

TEST_CASE("Bad arguments end with status 2 and a sentence that says what is wrong") {
  struct Case {
    const char* arguments;
    const char* says;
  };
  for (const Case& bad :
       {Case{"--agents 0 --strategy cr", "agents"}, Case{"--agents 10001 --strategy cr", "agents"},
        Case{"--agents two --strategy cr", "--agents"}, Case{"--strategy cr", "--agents"},
        Case{"--agents 2", "--strategy"}, Case{"--agents 2 --strategy cr --policy x", "--policy"},
        Case{"--agents 2 --strategy nobody", "nobody"},
        Case{"--agents 2 --strategy cr --noise -0.1", "noise"},
        Case{"--agents 2 --strategy cr --speed 0", "speed"},
        Case{"--agents 2 --strategy cr --episodes 0", "episodes"},
        Case{"--agents 2 --strategy cr --seed -1", "--seed"},
        Case{"--agents 2 --strategy cr --seed 18446744073709551616", "--seed"},
        Case{"--agents 2 --strategy cr --horizon 9", "--horizon"},
        Case{"--agents 2 --strategy cr --protocol other", "--protocol"},
        Case{"--agents 2 --strategy cr --json /nowhere/r.json", "/nowhere/r.json"},
        Case{"--agents 2 --strategy cr --trace /nowhere/t.csv", "/nowhere/t.csv"},
        Case{"--agents 2 --strategy cr --unknown", "--unknown"}}) {
    CAPTURE(bad.arguments);
    const auto result = Ronda(Evaluate(bad.arguments));
    CHECK(result.status == 2);
    CHECK_THAT(result.output, Catch::Contains(bad.says));
  }
}

TEST_CASE("A map or policy that does not exist ends with status 3 and is named") {
  const auto map = Ronda("evaluate --map atlantis --agents 2 --strategy cr");
  CHECK(map.status == 3);
  CHECK_THAT(map.output, Catch::Contains("atlantis"));

  const auto policy = Ronda(Evaluate("--agents 2 --policy nobody"));
  CHECK(policy.status == 3);
  CHECK_THAT(policy.output, Catch::Contains("nobody"));
}

TEST_CASE("A kernel that is none ends with status 2, variable, value and what there is") {
  const auto result = Ronda(Evaluate("--agents 2 --strategy cr"), "RONDA_KERNEL=avx9");
  CHECK(result.status == 2);
  CHECK_THAT(result.output, Catch::Contains("RONDA_KERNEL is \"avx9\"") &&
                                Catch::Contains("this CPU has: baseline"));
  CHECK(Ronda("--version", "RONDA_KERNEL=baseline").status == 0);
}

TEST_CASE("A reward or observation of no such name ends with status 3 and the names there are") {
  const TemporaryFolder folder;
  const auto train = [&](const std::string& setting) {
    return Ronda("train --map 4nodes --agents 2 --run " + (folder.path() / "run").string() +
                 " --set " + setting);
  };
  const auto reward = train("reward=fame");
  CHECK(reward.status == 3);
  CHECK_THAT(reward.output, Catch::Contains("ranking") && Catch::Contains("final-average"));
  const auto observation = train("observation=pixels");
  CHECK(observation.status == 3);
  CHECK_THAT(observation.output, Catch::Contains("sorted") && Catch::Contains("matrix"));
  const auto alpha = train("observation_alpha=1e5");
  CHECK(alpha.status == 3);
  CHECK_THAT(alpha.output, Catch::Contains("observation_alpha"));
}

TEST_CASE("Help and version are no errors, a missing command is") {
  CHECK(Ronda("--version").output.starts_with("ronda "));
  CHECK(Ronda("--help").status == 0);
  CHECK_THAT(Ronda("evaluate --help").output, Catch::Contains("Example"));
  CHECK_THAT(Ronda("compare --help").output, Catch::Contains("Example"));
  CHECK_THAT(Ronda("bounds --help").output, Catch::Contains("Example"));
  CHECK(Ronda("").status == 2);
}

}  // namespace
}  // namespace ronda
