// The real cluster: `ronda train` with its replay, learner and actors as processes over Fast DDS.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>

#include "common/policies/policy_file.h"
#include "tests/system/launched_run.h"

namespace ronda {
namespace {

using std::chrono::seconds;

TEST_CASE("A cluster learns the optimal patrol of the 4-node map with two robots within 10 %") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("120000"));

  // Three kinds of processes, children of the launcher, with names of their own.
  REQUIRE(WaitUntil(
      [&] {
        return ChildrenNamed(run.pid(), "ronda-actor").size() == 2 &&
               ChildrenNamed(run.pid(), "ronda-replay").size() == 1 &&
               ChildrenNamed(run.pid(), "ronda-learner").size() == 1;
      },
      seconds(30)));
  const ExitStatus status = run.WaitForEnd(seconds(200));

  INFO(run.Output());
  CHECK(status.code == 0);
  const auto summary = run.Summary();
  CheckCounts(summary);
  CHECK(summary["decisions"].get<std::uint64_t>() >= 120'000);
  CHECK(summary["transitions_lost"] == 0);
  CHECK(summary["transitions_forgotten"] == 0);
  CHECK(summary["agi_s"]["mean"].get<double>() <= 27.5);  // the optimum is 25, cyclic has 32.5
  CHECK(summary["best_classical_agi_s"]["mean"].get<double>() > 27.5);

  const TrainingFacts facts = ReadPolicyFile(run.folder() / "checkpoints/best.ronda").training;
  CHECK(facts.map == "4nodes");
  CHECK(facts.agents == 2);
  CHECK(facts.speed_mps == 1.0);
  CHECK(facts.algorithm == "dqn");
  CHECK(facts.reward == "hindsight");
  CHECK(facts.discount_horizon_s > 0.0);
  CHECK(facts.decisions > 0);
  CHECK(facts.training_s > 0.0);
  CHECK(facts.agi_s == summary["agi_s"]["mean"]);

  // The policy that it kept does the same under `ronda evaluate`.
  LaunchedRun evaluate(temporary.path() / "run",
                       {"evaluate", "--map", "4nodes", "--agents", "2", "--policy", "{run}",
                        "--json", (temporary.path() / "evaluation.json").string()});
  CHECK(evaluate.WaitForEnd(seconds(60)).code == 0);
  std::ifstream file(temporary.path() / "evaluation.json");
  const auto evaluation = nlohmann::json::parse(file);
  CHECK(evaluation["agi_s"]["mean"] == summary["agi_s"]["mean"]);

  // The same command again: it has its decisions, says so and ends; a larger budget goes on.
  LaunchedRun again(temporary.path() / "run", TrainFourNodes("120000"));
  CHECK(again.WaitForEnd(seconds(20)).code == 0);
  CHECK(again.Output().find("already") != std::string::npos);
  LaunchedRun larger(temporary.path() / "run", TrainFourNodes("140000"));
  CHECK(larger.WaitForEnd(seconds(100)).code == 0);
  const auto later = larger.Summary();
  CheckCounts(later);
  CHECK(later["decisions"].get<std::uint64_t>() >= 140'000);
  CHECK(later["updates"].get<std::uint64_t>() > summary["updates"].get<std::uint64_t>());
  CHECK(later["weights_version"].get<std::uint64_t>() >
        summary["weights_version"].get<std::uint64_t>());
}

TEST_CASE(
    "A run goes on after kill -9 of an actor, the replay and the learner, and counts what it "
    "cost") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  for (const char* victim : {"ronda-actor", "ronda-replay", "ronda-learner"}) {
    const std::uint64_t stored = run.StoredTransitions();
    REQUIRE(WaitUntil([&] { return run.StoredTransitions() > stored + 2000; }, seconds(60)));
    const auto before = ChildrenNamed(run.pid(), victim);
    REQUIRE_FALSE(before.empty());
    kill(before.front(), SIGKILL);
    REQUIRE(WaitUntil(
        [&] {
          const auto now = ChildrenNamed(run.pid(), victim);
          return now.size() == before.size() &&
                 std::find(now.begin(), now.end(), before.front()) == now.end();
        },
        seconds(30)));
  }
  REQUIRE(GoesOn(run));

  run.Signal(SIGTERM);
  const ExitStatus status = run.WaitForEnd(seconds(30));

  INFO(run.Output());
  CHECK(status.code == 128 + SIGTERM);
  const auto summary = run.Summary();
  CheckCounts(summary);
  CHECK(summary["restarts"] == nlohmann::json({{"actor", 1}, {"replay", 1}, {"learner", 1}}));
  CHECK(summary["transitions_forgotten"].get<std::uint64_t>() > 0);
  CHECK(run.Output().find("signal 9") != std::string::npos);
  CHECK(std::filesystem::exists(run.folder() / "checkpoints" / "latest.ronda"));
}

TEST_CASE(
    "A run goes on after each role was paused for six seconds, with nothing lost or doubled") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  REQUIRE(WaitUntil([&] { return run.StoredTransitions() > 2000; }, seconds(60)));
  for (const char* victim : {"ronda-actor", "ronda-replay", "ronda-learner"}) {
    const auto pids = ChildrenNamed(run.pid(), victim);
    REQUIRE_FALSE(pids.empty());
    const double paused_at_s = run.State()["wall_s"];
    kill(pids.front(), SIGSTOP);
    REQUIRE(WaitUntil([&] { return run.State()["wall_s"].get<double>() > paused_at_s + 6.0; },
                      seconds(60)));
    kill(pids.front(), SIGCONT);
    REQUIRE(GoesOn(run));
  }

  run.Signal(SIGTERM);
  CHECK(run.WaitForEnd(seconds(30)).code == 128 + SIGTERM);
  const auto summary = run.Summary();
  CheckCounts(summary);
  CHECK(summary["transitions_lost"] == 0);
  CHECK(summary["restarts"] == nlohmann::json({{"actor", 0}, {"replay", 0}, {"learner", 0}}));
}

TEST_CASE("Killing the launcher ends its children, and the run folder can be taken over") {
  const TemporaryFolder temporary;
  std::vector<pid_t> children;
  {
    LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
    REQUIRE(WaitUntil([&] { return run.StoredTransitions() > 2000; }, seconds(60)));
    for (const char* name : {"ronda-actor", "ronda-replay", "ronda-learner"}) {
      for (const pid_t pid : ChildrenNamed(run.pid(), name)) children.push_back(pid);
    }
    REQUIRE(children.size() == 4);

    LaunchedRun second(temporary.path() / "run", TrainFourNodes("1000000000"));
    CHECK(second.WaitForEnd(seconds(20)).code == 8);

    run.Signal(SIGKILL);
    CHECK(run.WaitForEnd(seconds(10)).signal == SIGKILL);
  }
  for (const pid_t pid : children) {
    CHECK(WaitUntil([&] { return !IsAlive(pid); }, seconds(30)));
  }

  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  const std::uint64_t stored = run.StoredTransitions();
  REQUIRE(WaitUntil([&] { return run.StoredTransitions() > stored + 2000; }, seconds(60)));
  run.Signal(SIGINT);
  CHECK(run.WaitForEnd(seconds(30)).code == 128 + SIGINT);
  CheckCounts(run.Summary());
}

TEST_CASE("A cluster works with the socket buffers that a bare Debian grants") {
  const TemporaryFolder temporary;
  auto arguments = TrainFourNodes("20000");
  arguments.insert(arguments.end(), {"--set", "dds.socket_buffer_bytes=212992"});
  LaunchedRun run(temporary.path() / "run", arguments);

  CHECK(run.WaitForEnd(seconds(120)).code == 0);
  CheckCounts(run.Summary());
  CHECK(run.Summary()["transitions_lost"] == 0);
}

TEST_CASE("Bad input is refused with its status and leaves no run folder behind") {
  struct Case {
    std::vector<std::string> arguments;
    int code;
    std::string message;
  };
  const std::vector<Case> cases{
      {{"train", "--run", "{run}", "--map", "atlantis"}, 3, "atlantis"},
      {{"train", "--run", "{run}", "--agents", "0"}, 3, "run.agents"},
      {{"train", "--run", "{run}", "--set", "dqn.batch_siz=64"}, 3, "did you mean dqn.batch_size"},
      {{"train", "--run", "{run}", "--set", "replay.error_buffer=10"}, 3, "replay.error_buffer"},
      {{"train", "--run", "{run}", "--for", "soon"}, 2, "--for"},
      {{"train", "--run", "{run}", "--config", "/nowhere.toml"}, 3, "/nowhere.toml"},
      {{"train", "--nonsense"}, 2, "nonsense"},
      {{"evaluate", "--map", "4nodes", "--agents", "2", "--policy", "nobody"}, 3, "nobody"},
  };
  for (const Case& one : cases) {
    const TemporaryFolder temporary;
    LaunchedRun run(temporary.path() / "run", one.arguments);
    const ExitStatus status = run.WaitForEnd(seconds(20));
    INFO(run.Output());
    CHECK(status.code == one.code);
    CHECK(run.Output().find(one.message) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(run.folder()));
  }
}

}  // namespace
}  // namespace ronda
