// A running cluster, asked and changed by other commands: scale, status, runs, stop.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>

#include "tests/system/launched_run.h"

namespace ronda {
namespace {

using std::chrono::seconds;

/// `ronda ARGUMENTS…` about a run folder; its exit status and output.
struct Answer {
  int code = 0;
  std::string output;
};

Answer Ask(const std::filesystem::path& run_folder, std::vector<std::string> arguments) {
  LaunchedRun command(run_folder, std::move(arguments));
  const ExitStatus status = command.WaitForEnd(seconds(100));
  const std::string all = command.Output();  // appended to what the run itself prints
  return {.code = status.signal == 0 ? status.code : -status.signal, .output = all};
}

int Scale(const LaunchedRun& run, int actors) {
  return Ask(run.folder(), {"scale", "--run", "{run}", "--actors", std::to_string(actors)}).code;
}

std::size_t Actors(const LaunchedRun& run) {
  return ChildrenNamed(run.pid(), "ronda-actor").size();
}

TEST_CASE("A run scaled 2 to 6 to 1 to 3 actors loses and doubles nothing") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  REQUIRE(GoesOn(run));
  // Somebody watches, with an output of its own, until the run is over.
  LaunchedRun watcher(temporary.path() / "watch",
                      {"watch", "--run", run.folder().string(), "--plain"});

  for (const int actors : {6, 1, 3}) {
    INFO(run.Output());
    REQUIRE(Scale(run, actors) == 0);
    CHECK(Actors(run) == static_cast<std::size_t>(actors));
    const auto status = run.Status();
    CHECK(status["actors_wanted"] == actors);
    for (const auto& process : status["processes"]) {
      if (process["role"] == "actor") CHECK(process["weights_version"] > 0);
    }
    REQUIRE(GoesOn(run));
  }

  CHECK(Ask(run.folder(), {"stop", "--run", "{run}"}).code == 0);
  CHECK(run.WaitForEnd(seconds(30)).code == 128 + SIGTERM);
  CHECK(watcher.WaitForEnd(seconds(30)).code == 0);
  CHECK(watcher.Output().find("decisions/s") != std::string::npos);
  CHECK(watcher.Output().find("the run is stopped") != std::string::npos);
  const auto summary = run.Summary();
  CheckCounts(summary);
  CHECK(summary["transitions_lost"] == 0);
  CHECK(summary["restarts"] == nlohmann::json({{"actor", 0}, {"replay", 0}, {"learner", 0}}));
}

TEST_CASE("A run goes on when it is scaled while actors and the replay are killed") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  REQUIRE(GoesOn(run));
  REQUIRE(Scale(run, 6) == 0);

  kill(ChildrenNamed(run.pid(), "ronda-actor").back(), SIGKILL);
  REQUIRE(Scale(run, 4) == 0);
  kill(ChildrenNamed(run.pid(), "ronda-replay").front(), SIGKILL);
  REQUIRE(Scale(run, 1) == 0);  // the leaving ones wait for the new replay
  REQUIRE(Scale(run, 5) == 0);
  REQUIRE(GoesOn(run));

  run.Signal(SIGINT);
  CHECK(run.WaitForEnd(seconds(30)).code == 128 + SIGINT);
  INFO(run.Output());
  CheckCounts(run.Summary());
}

TEST_CASE("status tells a healthy run, a degraded one, an ended one and none apart") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  REQUIRE(GoesOn(run));
  const auto json_file = temporary.path() / "status-copy.json";
  const std::vector<std::string> ask{"status", "--run", "{run}", "--json", json_file.string()};

  REQUIRE(WaitUntil([&] { return Ask(run.folder(), ask).code == 0; }, seconds(30)));
  std::ifstream file(json_file);
  const auto healthy = nlohmann::json::parse(file);
  CHECK(healthy["state"] == "running");
  CHECK(healthy["problems"].empty());
  CHECK(healthy["processes"].size() == 4);
  CHECK(healthy["processes"][0]["pid"] == ChildrenNamed(run.pid(), "ronda-replay").front());

  const pid_t learner = ChildrenNamed(run.pid(), "ronda-learner").front();
  kill(learner, SIGSTOP);
  CHECK(WaitUntil([&] { return Ask(run.folder(), ask).code == 1; }, seconds(60)));
  CHECK(run.Status()["problems"].dump().find("learner") != std::string::npos);
  kill(learner, SIGCONT);
  CHECK(WaitUntil([&] { return Ask(run.folder(), ask).code == 0; }, seconds(60)));

  run.Signal(SIGKILL);
  CHECK(run.WaitForEnd(seconds(10)).signal == SIGKILL);
  const Answer abandoned = Ask(run.folder(), ask);
  CHECK(abandoned.code == 1);
  CHECK(abandoned.output.find("abandoned") != std::string::npos);
  CHECK(Ask(run.folder(), {"scale", "--run", "{run}", "--actors", "3"}).code == 3);
  CHECK(Ask(temporary.path() / "nowhere", ask).code == 3);

  LaunchedRun again(temporary.path() / "run", TrainFourNodes("1000000000"));
  REQUIRE(GoesOn(again));
  CHECK(Ask(run.folder(), {"stop", "--run", "{run}"}).code == 0);
  CHECK(Ask(run.folder(), ask).code == 0);  // stopped as it was asked to
  CHECK(again.WaitForEnd(seconds(30)).code == 128 + SIGTERM);

  const auto list_file = temporary.path() / "runs.json";
  CHECK(
      Ask(run.folder(), {"runs", "--root", temporary.path().string(), "--json", list_file.string()})
          .code == 0);
  std::ifstream list(list_file);
  const auto runs = nlohmann::json::parse(list);
  REQUIRE(runs.size() == 1);
  CHECK(runs[0]["map"] == "4nodes");
  CHECK(runs[0]["agents"] == 2);
  CHECK(runs[0]["state"] == "stopped");
  CHECK(runs[0]["age_s"].get<double>() > 0.0);
}

}  // namespace
}  // namespace ronda
