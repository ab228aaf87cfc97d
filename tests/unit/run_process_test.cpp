#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "common/run/child_process.h"
#include "common/run/paths.h"
#include "tests/temporary_folder.h"
#include "tests/unit/run_test_pipe.h"

namespace ronda {
namespace {

constexpr std::chrono::seconds kLong{20};

struct Outcome {
  ExitStatus status;
  std::vector<std::string> output;
};

Outcome RunHelper(const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  ChildProcess helper(ProgramFolder() / "run_test_helper", words, folder / "log");
  const auto status = helper.WaitFor(kLong);
  REQUIRE(status);
  return {*status, helper.LastLogLines(99)};
}

Outcome RunHelperUntilSignal(int signal, const std::string& status_of_body) {
  const TemporaryFolder folder;
  TestPipe pipe;
  ChildProcess helper(ProgramFolder() / "run_test_helper", {"stop", pipe.number(), status_of_body},
                      folder / "log");
  REQUIRE(pipe.Next() == TestPipe::Event::kReady);
  helper.Signal(signal);
  const auto status = helper.WaitFor(kLong);
  REQUIRE(status);
  return {*status, helper.LastLogLines(99)};
}

TEST_CASE("A process that SIGINT stopped exits with 130") {
  CHECK(RunHelperUntilSignal(SIGINT, "0").status.code == 130);
}

TEST_CASE("A process that SIGTERM stopped exits with 143") {
  CHECK(RunHelperUntilSignal(SIGTERM, "0").status.code == 143);
}

TEST_CASE("A status of the body's own stands after a signal") {
  CHECK(RunHelperUntilSignal(SIGTERM, "7").status.code == 7);
}

TEST_CASE("The first signal is the one that is remembered") {
  const Outcome outcome = RunHelper({"stop-twice"});
  CHECK(outcome.status.signal == 0);
  CHECK(outcome.status.code == 143);
}

TEST_CASE("An error is one line and gives its exit code") {
  const Outcome outcome = RunHelper({"throw", "error"});
  CHECK(outcome.status.code == 6);
  CHECK(outcome.output ==
        std::vector<std::string>{"helper: loss of update 12: must be finite, got nan"});
}

TEST_CASE("A standard exception is one line and gives 1") {
  const Outcome outcome = RunHelper({"throw", "standard"});
  CHECK(outcome.status.code == 1);
  CHECK(outcome.output == std::vector<std::string>{"helper: something else"});
}

TEST_CASE("Any other exception gives 1") { CHECK(RunHelper({"throw", "number"}).status.code == 1); }

TEST_CASE("EndWithParent ends a process whose parent is gone already") {
  const Outcome outcome = RunHelper({"orphan", "1"});  // pid 1 is not the helper's parent here
  CHECK(outcome.status.signal == SIGTERM);
}

TEST_CASE("EndWithParent leaves a process whose parent lives alone") {
  CHECK(RunHelper({"orphan", std::to_string(::getpid())}).status.code == 5);
}

}  // namespace
}  // namespace ronda
