// `ronda policy` as a user meets it: what it prints and writes, and what it refuses with which
// status.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/base/checked_file.h"
#include "common/base/whole_file.h"
#include "common/policies/policy_file.h"
#include "tests/temporary_folder.h"
#include "tests/unit/gradient_check.h"
#include "tests/unit/ronda_program.h"

namespace ronda {
namespace {

using Catch::Contains;
using testing::Ronda;

PolicyFile SomePolicy() {
  Rng rng(1);
  PolicyFile policy{.spec = {.kind = NetworkSpec::Kind::kCandidateScorer,
                             .observation_size = 78,
                             .num_actions = 3,
                             .features = 26,
                             .hidden = {5},
                             .schema = "patrol-candidates-26"},
                    .training = {.map = "4nodes",
                                 .agents = 2,
                                 .speed_mps = 1.5,
                                 .algorithm = "dqn",
                                 .seed = 3,
                                 .reward = "hindsight",
                                 .discount_horizon_s = 19.5,
                                 .decisions = 200'000,
                                 .training_s = 90.0,
                                 .agi_s = 25.0,
                                 .agi_ci95_s = 0.25,
                                 .ronda_version = "0.1.0"},
                    .version = 180,
                    .updates = 18000,
                    .weights = {}};
  policy.weights = testing::RandomVector<float>(rng, ParameterCount(policy.spec));
  return policy;
}

/// A run folder's checkpoints, and files beside it.
struct RunScene {
  RunScene() { std::filesystem::create_directories(folder / "run/checkpoints"); }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  TemporaryFolder folder;
};

TEST_CASE("policy info prints every fact, and writes them as JSON") {
  const RunScene scene;
  WritePolicyFile(scene.path("p.ronda"), SomePolicy());

  const auto result =
      Ronda("policy info " + scene.path("p.ronda") + " --json " + scene.path("p.json"));

  CHECK(result.status == 0);
  for (const char* fact : {"26 features → 5 → 1", "141 parameters", "patrol-candidates-26",
                           "4nodes, 2 robots, 1.5 m/s",
                           "dqn, seed 3, 18000 updates, 200000 decisions", "weights version 180",
                           "hindsight", "19.5 s", "25.00 ± 0.25 s", "format 2", "ronda 0.1.0"}) {
    CHECK_THAT(result.output, Contains(fact));
  }
  const auto json = nlohmann::json::parse(std::ifstream(scene.path("p.json")));
  CHECK(json["format"] == 2);
  CHECK(json["size_bytes"] == std::filesystem::file_size(scene.path("p.ronda")));
  CHECK(json["network"]["hidden"] == std::vector<int>{5});
  CHECK(json["network"]["parameters"] == 141);
  CHECK(json["observation_schema"] == "patrol-candidates-26");
  CHECK(json["decisions"] == 200'000);
  CHECK(json["agi_s"] == nlohmann::json({{"mean", 25.0}, {"ci95", 0.25}}));
}

TEST_CASE("policy info leaves out what a file does not know") {
  const RunScene scene;
  const auto result =
      Ronda("policy info " RONDA_SOURCE_DIR "/tests/golden/policy_format_1.ronda --json " +
            scene.path("p.json"));
  CHECK(result.status == 0);
  CHECK_THAT(result.output, Contains("format 1") && !Contains("judged") && !Contains("reward"));
  const auto json = nlohmann::json::parse(std::ifstream(scene.path("p.json")));
  CHECK(json["agi_s"].is_null());
  CHECK(json["reward"].is_null());
  CHECK(json["seed"].is_null());
}

TEST_CASE("policy extract takes the best policy of a run, its latest before there is a best") {
  const RunScene scene;
  PolicyFile policy = SomePolicy();
  policy.updates = 1;
  WritePolicyFile(scene.path("run/checkpoints/latest.ronda"), policy);
  CHECK(Ronda("policy extract " + scene.path("run ") + scene.path("a.ronda")).status == 0);
  CHECK(ReadPolicyFile(scene.path("a.ronda")) == policy);

  WritePolicyFile(scene.path("run/checkpoints/best.ronda"), SomePolicy());
  CHECK(Ronda("policy extract " + scene.path("run ") + scene.path("b.ronda")).status == 0);
  CHECK(ReadPolicyFile(scene.path("b.ronda")) == SomePolicy());
  CHECK(Ronda("policy extract " + scene.path("run@latest ") + scene.path("c.ronda")).status == 0);
  CHECK(ReadPolicyFile(scene.path("c.ronda")) == policy);
  CHECK(std::distance(std::filesystem::directory_iterator(scene.folder.path()), {}) == 4);
}

TEST_CASE("policy extract replaces a file only where it is told to") {
  const RunScene scene;
  WritePolicyFile(scene.path("run/checkpoints/best.ronda"), SomePolicy());
  WriteWholeFile(scene.path("mine"), "precious");
  const std::string command = "policy extract " + scene.path("run ") + scene.path("mine");

  const auto refused = Ronda(command);
  CHECK(refused.status == 2);
  CHECK_THAT(refused.output, Contains(scene.path("mine")) && Contains("--force"));
  CHECK(ReadWholeFile(scene.path("mine")) == "precious");

  CHECK(Ronda(command + " --force").status == 0);
  CHECK(ReadPolicyFile(scene.path("mine")) == SomePolicy());
  CHECK(Ronda("policy extract " + scene.path("run ") + scene.path("run --force")).status == 2);
}

TEST_CASE("policy extract says that a run has no policy yet") {
  const RunScene scene;
  const auto result = Ronda("policy extract " + scene.path("run ") + scene.path("out"));
  CHECK(result.status == 3);
  CHECK_THAT(result.output, Contains(scene.path("run")) && Contains("no trained policy"));
  CHECK_FALSE(std::filesystem::exists(scene.path("out")));
}

TEST_CASE("Foreign, torn, damaged and newer files end with status 5, the file's name and why") {
  const RunScene scene;
  const std::string file = scene.path("p.ronda");
  WritePolicyFile(file, SomePolicy());
  const std::string whole = ReadWholeFile(file);
  const auto refused = [&](const std::string& bytes, const std::string& why) {
    WriteWholeFile(file, bytes);
    for (const std::string& command :
         {"policy info " + file, "policy extract " + file + " " + scene.path("out"),
          "evaluate --map 4nodes --agents 2 --policy " + file}) {
      const auto result = Ronda(command);
      CHECK(result.status == 5);
      CHECK_THAT(result.output, Contains(file + ": ") && Contains(why));
    }
  };
  refused("[run]\nmap = \"cumberland\"\n", "not a RONDAPOL file");
  refused(whole.substr(0, whole.size() / 2), "torn");
  refused(whole.substr(0, 3), "torn");
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
  refused(flipped, "damaged");
  WriteCheckedFile(file, "RONDAPOL", 3, "of the future");
  refused(ReadWholeFile(file), "written by a newer ronda: format 3, this one reads up to 2");
  CHECK_FALSE(std::filesystem::exists(scene.path("out")));
}

TEST_CASE("A policy with an observation that is not known ends with status 3 and its file's name") {
  const RunScene scene;
  PolicyFile policy = SomePolicy();
  policy.spec.schema = "patrol-of-tomorrow";
  WritePolicyFile(scene.path("p.ronda"), policy);
  const auto result = Ronda("evaluate --map 4nodes --agents 2 --policy " + scene.path("p.ronda"));
  CHECK(result.status == 3);
  CHECK_THAT(result.output, Contains(scene.path("p.ronda")) && Contains("patrol-of-tomorrow"));
  CHECK(Ronda("policy info " + scene.path("p.ronda")).status == 0);
}

TEST_CASE("policy without a command or with a wrong one ends with status 2") {
  CHECK(Ronda("policy").status == 2);
  CHECK(Ronda("policy extract onlyone").status == 2);
  CHECK(Ronda("policy burn x").status == 2);
  CHECK_THAT(Ronda("policy extract --help").output, Contains("Example"));
}

}  // namespace
}  // namespace ronda
