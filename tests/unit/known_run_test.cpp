#include "deploy/known_run.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "common/base/error.h"
#include "common/run/run_folder.h"
#include "deploy/kept_files.h"
#include "deploy/wanted_actors.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

RunStatus Running() {
  RunStatus status;
  status.map = "grid";
  status.state = "running";
  status.launcher_pid = 77;
  status.written_unix_s = 1000.0;
  status.best_agi_s = 12.5;
  status.decisions_per_s = 40'000.0;
  status.processes = {{.role = "actor",
                       .index = 2,
                       .pid = 40,
                       .state = "running",
                       .rates_per_s = {{"decisions", 21000.0}},
                       .lag_versions = std::nullopt,
                       .weights_version = 4,
                       .restarts = 1,
                       .last_error = "signal 9 (Killed)",
                       .silent_s = 0.25}};
  return status;
}

TEST_CASE("A run's picture reads back as it was written") {
  const TemporaryFolder folder;
  RunStatus status = Running();
  status.curve = {{.training_s = 1.5, .agi_s = 14.0}};
  status.events = {{.unix_s = 999.0, .text = "2 → 6 actors"}};
  status.channels.emplace_back().topic = "weights";

  WriteRunStatus(folder.path(), status);
  const auto got = ReadRunStatus(folder.path());

  REQUIRE(got);
  CHECK(RunStatusAsJson(*got) == RunStatusAsJson(status));
  CHECK(got->processes[0].rates_per_s == status.processes[0].rates_per_s);
  CHECK_FALSE(got->processes[0].lag_versions);
  CHECK(got->best_agi_s == 12.5);
  CHECK_FALSE(ReadRunStatus(folder.path() / "elsewhere"));
}

TEST_CASE("A picture that is none is refused with its path") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "status.json") << "{\"map\": 7}";
  CHECK_THROWS_WITH(ReadRunStatus(folder.path()), Catch::Contains("status.json"));
}

TEST_CASE("A run that nobody holds and that did not end is abandoned") {
  RunStatus status = Running();
  Judge(std::nullopt, 1001.0, status);
  CHECK(status.state == "abandoned");
  CHECK(status.problems.size() == 1);
  CHECK(status.processes.empty());
  CHECK(status.decisions_per_s == 0.0);

  RunStatus ended = Running();
  ended.state = "stopped";
  Judge(std::nullopt, 1001.0, ended);
  CHECK(ended.state == "stopped");
  CHECK(ended.problems.empty());
}

TEST_CASE("A launcher that writes no more is a problem, and one that has just begun is not") {
  RunStatus fresh = Running();
  Judge(77, 1004.0, fresh);
  CHECK(fresh.problems.empty());

  RunStatus silent = Running();
  Judge(77, 1007.0, silent);
  REQUIRE(silent.problems.size() == 1);
  CHECK(silent.problems[0] == "the launcher (process 77) has been silent for 7 s");

  RunStatus former = Running();
  Judge(78, 2000.0, former);
  CHECK(former.state == "starting");
  CHECK(former.launcher_pid == 78);
  CHECK(former.problems.empty());
}

TEST_CASE("Looking who holds a run folder does not take it") {
  const TemporaryFolder temporary;
  const auto path = temporary.path() / "run";
  CHECK_FALSE(RunFolder::Holder(path));
  {
    const RunFolder folder(path);
    CHECK(RunFolder::Holder(path) == getpid());
    CHECK_THROWS_AS(RunFolder(path), Error);
  }
  CHECK_FALSE(RunFolder::Holder(path));
  const RunFolder again(path);
}

TEST_CASE("What is no run's folder is refused with what is missing") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(FindRun(folder.path() / "nowhere"), Catch::Contains("no such run"));
  CHECK_THROWS_WITH(FindRun(folder.path()), Catch::Contains("config.toml"));
  CHECK(FindRuns(folder.path()).empty());
}

TEST_CASE("A run that cannot be read hides no other") {
  const TemporaryFolder root;
  for (const char* name : {"bad", "good"}) {
    std::filesystem::create_directory(root.path() / name);
    std::ofstream(root.path() / name / "config.toml") << "";
  }
  std::ofstream(root.path() / "bad" / "status.json") << "half a pict";
  WriteRunStatus(root.path() / "good", Running());

  const auto runs = FindRuns(root.path());

  REQUIRE(runs.size() == 2);
  CHECK(runs[0].status.state == "unreadable");
  CHECK(runs[0].status.problems.at(0).find("status.json") != std::string::npos);
  CHECK(runs[1].status.map == "grid");
}

TEST_CASE("The wanted number of actors is read as written, and refused beyond its range") {
  const TemporaryFolder folder;
  WriteWantedActors(folder.path(), 6);
  CHECK(ReadWantedActors(folder.path()) == 6);
  for (const char* text : {"0", "91", "-1", "six", "", "3 4", "1.5"}) {
    std::ofstream(folder.path() / "actors", std::ios::trunc) << text;
    CHECK_THROWS_WITH(ReadWantedActors(folder.path()),
                      Catch::Contains("actors") && Catch::Contains("from 1 to 90") &&
                          Catch::Contains("'" + std::string(text) + "'"));
  }
}

TEST_CASE("A file that cannot be kept is said once, and once when it can be again") {
  KeptFiles sut;
  const auto fail = [] { throw InputError("state.json: No space left on device"); };

  CHECK(sut.Write("state.json", [] {}).empty());
  CHECK_THAT(sut.Write("state.json", fail), Catch::Contains("No space left"));
  CHECK(sut.Write("state.json", fail).empty());
  CHECK(sut.unwritten().size() == 1);
  CHECK_THAT(sut.Write("state.json", [] {}), Catch::Contains("written again"));
  CHECK(sut.unwritten().empty());
}

}  // namespace
}  // namespace ronda
