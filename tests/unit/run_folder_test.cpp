#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>
#include <memory>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/run/child_process.h"
#include "common/run/metrics_log.h"
#include "common/run/paths.h"
#include "common/run/run_domain.h"
#include "common/run/run_folder.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

TEST_CASE("A run folder holds logs and checkpoints, and is made with its parents") {
  const TemporaryFolder folder;
  const RunFolder sut(folder / "runs/first");
  CHECK(std::filesystem::is_directory(folder / "runs/first/logs"));
  CHECK(std::filesystem::is_directory(folder / "runs/first/checkpoints"));
  CHECK(sut.config_file() == folder / "runs/first/config.toml");
}

TEST_CASE("A run folder that another process holds is refused with that process's id") {
  const TemporaryFolder folder;
  const RunFolder held(folder / "run");
  ChildProcess second(ProgramFolder() / "run_test_helper", {"lock", held.path()}, folder / "log");
  const auto status = second.WaitFor(std::chrono::seconds(20));
  REQUIRE(status);
  CHECK(status->code == static_cast<int>(ExitCode::kRunFolderInUse));
  CHECK(second.LastLogLines(9) ==
        std::vector<std::string>{"helper: " + held.path().string() +
                                 ": the run folder is in use by process " +
                                 std::to_string(::getpid())});
}

TEST_CASE("A run folder is free again when its holder is gone") {
  const TemporaryFolder folder;
  { const RunFolder first(folder / "run"); }
  CHECK_NOTHROW(RunFolder(folder / "run"));
}

TEST_CASE("A child does not hold its parent's run folder") {
  const TemporaryFolder folder;
  auto first = std::make_unique<RunFolder>(folder / "run");
  const ChildProcess child("/bin/sh", {"-c", "exec tail -f /dev/null"}, folder / "log");
  first.reset();
  CHECK_NOTHROW(RunFolder(folder / "run"));
}

TEST_CASE("A run folder that cannot be made is refused with the reason") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "file", "");
  const std::string path = folder / "file/run";
  CHECK_THROWS_WITH(RunFolder(path),
                    path + ": the run folder cannot be made or written: Not a directory");
  CHECK_THROWS_AS(RunFolder(path), InputError);
}

TEST_CASE("The default name of a run is its map and the local time") {
  ::setenv("TZ", "UTC", 1);
  ::tzset();
  CHECK(RunFolder::DefaultName("cumberland", 1'700'000'000) == "cumberland-20231114-221320");
  CHECK(RunFolder::DefaultName("maps/my.graph", 0) == "my-19700101-000000");
}

TEST_CASE("A default path that is taken gets a number") {
  ::setenv("TZ", "UTC", 1);
  ::tzset();
  const TemporaryFolder folder;
  std::filesystem::current_path(folder.path());
  CHECK(RunFolder::DefaultPath("grid", 0) == "runs/grid-19700101-000000");
  std::filesystem::create_directories("runs/grid-19700101-000000");
  std::filesystem::create_directories("runs/grid-19700101-000000-2");
  CHECK(RunFolder::DefaultPath("grid", 0) == "runs/grid-19700101-000000-3");
  std::filesystem::current_path("/");
}

TEST_CASE("A whole file is replaced, and nothing temporary stays") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "file", "a much longer text than the next");
  WriteWholeFile(folder / "file", std::string("two\0lines\n", 10));
  CHECK(ReadWholeFile(folder / "file") == std::string("two\0lines\n", 10));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("A whole file that cannot be written leaves the old one and gives the reason") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "file", "old");
  std::filesystem::create_directory(folder / "file.tmp");  // in the way of the temporary file
  const std::string path = folder / "file";
  CHECK_THROWS_WITH(WriteWholeFile(path, "new"), path + ": cannot be written: Is a directory");
  CHECK(ReadWholeFile(path) == "old");
}

TEST_CASE("A file that is not there or is a folder cannot be read, and the reason is given") {
  const TemporaryFolder folder;
  const std::string path = folder / "none";
  CHECK_THROWS_WITH(ReadWholeFile(path), path + ": cannot be read: No such file or directory");
  CHECK_THROWS_WITH(ReadWholeFile(folder.path()),
                    folder.path().string() + ": cannot be read: Is a directory");
}

TEST_CASE("The last lines of a long file are whole lines") {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "line " + std::to_string(i) + "\n";
  WriteWholeFile(folder / "file", text);
  CHECK(LastLines(folder / "file", 2) == std::vector<std::string>{"line 19998", "line 19999"});
  CHECK(LastLines(folder / "file", 100'000).front().starts_with("line "));
  CHECK(LastLines(folder / "none", 2).empty());
}

TEST_CASE("Two runs get different domains, from 1 to 100") {
  const RunDomain first(7);
  const RunDomain second(7);
  CHECK(first.domain() != second.domain());
  CHECK(first.domain() >= 1);
  CHECK(second.domain() <= 100);
}

TEST_CASE("A domain is taken for other processes too, and free again after its run") {
  const TemporaryFolder folder;
  auto held = std::make_unique<RunDomain>(3);
  const std::string number = std::to_string(held->domain());
  const auto take = [&] {
    ChildProcess other(ProgramFolder() / "run_test_helper", {"domain", number}, folder / "log");
    return other.WaitFor(std::chrono::seconds(20)).value_or(ExitStatus{.code = -1}).code;
  };
  CHECK(take() == static_cast<int>(ExitCode::kTransport));
  held.reset();
  CHECK(take() == 0);
}

TEST_CASE("A child does not hold its parent's domain") {
  const TemporaryFolder folder;
  auto first = std::make_unique<RunDomain>(5);
  const int domain = first->domain();
  const ChildProcess child("/bin/sh", {"-c", "exec tail -f /dev/null"}, folder / "log");
  first.reset();
  CHECK_NOTHROW(RunDomain(0, {domain, domain}));
}

TEST_CASE("Where all domains are taken there is an error") {
  const RunDomain held(11);
  const int domain = held.domain();
  CHECK_THROWS_AS(RunDomain(0, {domain, domain}), TransportError);
}

TEST_CASE("Metrics are JSON lines in the order that they are given") {
  const TemporaryFolder folder;
  MetricsLog sut(folder / "metrics.jsonl", "learner");
  sut.Append(1.5, {{"updates", std::int64_t{3}}, {"loss", 0.25}, {"note", std::string("a\nb")}});
  sut.Append(2.0, {{"loss", std::numeric_limits<double>::quiet_NaN()}});
  CHECK(ReadWholeFile(folder / "metrics.jsonl") ==
        "{\"time_s\":1.5,\"process\":\"learner\",\"updates\":3,\"loss\":0.25,\"note\":\"a\\nb\"}\n"
        "{\"time_s\":2.0,\"process\":\"learner\",\"loss\":null}\n");
}

TEST_CASE("A metrics line that a crash cut short spoils no other") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "metrics.jsonl", "{\"time_s\":1.");
  MetricsLog(folder / "metrics.jsonl", "actor").Append(2.0, {});
  CHECK(ReadWholeFile(folder / "metrics.jsonl") ==
        "{\"time_s\":1.\n{\"time_s\":2.0,\"process\":\"actor\"}\n");
}

}  // namespace
}  // namespace ronda
