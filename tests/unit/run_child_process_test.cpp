#include <csignal>

#include <catch2/catch.hpp>

#include "common/base/error.h"
#include "common/run/child_process.h"
#include "common/run/paths.h"
#include "tests/temporary_folder.h"
#include "tests/unit/run_test_pipe.h"

namespace ronda {
namespace {

constexpr std::chrono::seconds kLong{20};

ChildProcess Shell(const std::string& script, const std::filesystem::path& log) {
  return ChildProcess("/bin/sh", {"-c", script}, log);
}

std::filesystem::path Helper() { return ProgramFolder() / "run_test_helper"; }

TEST_CASE("A child's exit status is reported") {
  const TemporaryFolder folder;
  ChildProcess sut = Shell("exit 3", folder / "log");
  const auto status = sut.WaitFor(kLong);
  REQUIRE(status);
  CHECK(status->code == 3);
  CHECK(status->signal == 0);
  CHECK(status->Description() == "exit status 3");
}

TEST_CASE("A child that is killed is reported with its signal") {
  const TemporaryFolder folder;
  ChildProcess sut = Shell("kill -9 $$", folder / "log");
  const auto status = sut.WaitFor(kLong);
  REQUIRE(status);
  CHECK(status->signal == SIGKILL);
  CHECK(status->Description() == "signal 9 (Killed)");
}

TEST_CASE("A child that runs has no status, and Signal ends it") {
  const TemporaryFolder folder;
  TestPipe pipe;
  ChildProcess sut(Helper(), {"hold", pipe.number()}, folder / "log");
  REQUIRE(pipe.Next() == TestPipe::Event::kReady);
  CHECK_FALSE(sut.Poll());
  CHECK_FALSE(sut.WaitFor(std::chrono::milliseconds(1)));
  sut.Signal(SIGTERM);
  const auto status = sut.WaitFor(kLong);
  REQUIRE(status);
  CHECK(status->signal == SIGTERM);
  sut.Signal(SIGTERM);  // nothing: it has ended
  CHECK(sut.Poll()->signal == SIGTERM);
}

TEST_CASE("stdout and stderr of each start are appended to the log") {
  const TemporaryFolder folder;
  const auto log = folder / "log";
  REQUIRE(Shell("echo first; echo second >&2", log).WaitFor(kLong));
  ChildProcess sut = Shell("echo third", log);
  REQUIRE(sut.WaitFor(kLong));
  CHECK(sut.LastLogLines(2) == std::vector<std::string>{"second", "third"});
  CHECK(sut.LastLogLines(9).size() == 3);
}

TEST_CASE("A program that cannot be executed is an error with the reason") {
  const TemporaryFolder folder;
  try {
    ChildProcess("/no/such/program", {}, folder / "log");
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.exit_code() == ExitCode::kChildGaveUp);
    CHECK(std::string(error.what()) ==
          "/no/such/program: cannot be executed: No such file or directory");
  }
}

TEST_CASE("A log that cannot be opened is an error with the reason") {
  CHECK_THROWS_WITH(Shell("exit 0", "/no/such/folder/log"),
                    "/no/such/folder/log: the log cannot be opened: No such file or directory");
}

TEST_CASE("A child has a process group of its own and no input") {
  const TemporaryFolder folder;
  ChildProcess sut = Shell("ps -o pgid= -p $$ | tr -d ' '; cat", folder / "log");
  REQUIRE(sut.WaitFor(kLong));
  CHECK(sut.LastLogLines(9) == std::vector<std::string>{std::to_string(sut.pid())});
}

TEST_CASE("A child blocks no signal that its parent blocks") {
  const TemporaryFolder folder;
  sigset_t signals, before;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, &before);
  ChildProcess sut = Shell("kill -TERM $$; exit 0", folder / "log");
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  const auto status = sut.WaitFor(kLong);
  REQUIRE(status);
  CHECK(status->signal == SIGTERM);
}

TEST_CASE("The destructor ends a child that still runs") {
  const TemporaryFolder folder;
  TestPipe pipe;
  {
    const ChildProcess sut(Helper(), {"hold", pipe.number()}, folder / "log");
    pipe.CloseOwnEnd();
    REQUIRE(pipe.Next() == TestPipe::Event::kReady);
  }
  CHECK(pipe.Next() == TestPipe::Event::kAllEnded);
}

TEST_CASE("A child that is moved is still one child") {
  const TemporaryFolder folder;
  ChildProcess first = Shell("exit 4", folder / "log");
  ChildProcess sut = std::move(first);
  const auto status = sut.WaitFor(kLong);
  REQUIRE(status);
  CHECK(status->code == 4);
}

TEST_CASE("A child ends when its parent is killed") {
  const TemporaryFolder folder;
  TestPipe pipe;
  ChildProcess parent(Helper(), {"parent", pipe.number(), folder / "child.log"},
                      folder / "parent.log");
  pipe.CloseOwnEnd();
  REQUIRE(pipe.Next() == TestPipe::Event::kReady);  // said by the grandchild
  parent.Signal(SIGKILL);
  REQUIRE(parent.WaitFor(kLong)->signal == SIGKILL);
  CHECK(pipe.Next() == TestPipe::Event::kAllEnded);  // both have closed it
}

}  // namespace
}  // namespace ronda
