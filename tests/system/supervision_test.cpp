// What the launcher does when the machine is against it: each case ends in a sentence that says
// what is the matter.
#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <memory>
#include <set>

#include "common/base/file_descriptor.h"
#include "common/run/run_domain.h"
#include "tests/system/launched_run.h"

namespace ronda {
namespace {

using std::chrono::seconds;

bool Says(const LaunchedRun& run, const std::string& text) {
  return run.Output().find(text) != std::string::npos;
}

/// What is written to the file next fails as on a full disk: its temporary file leads to /dev/full.
void FillDiskFor(const std::filesystem::path& file) {
  std::error_code exists;
  std::filesystem::create_symlink("/dev/full", file.string() + ".tmp", exists);
}

TEST_CASE("A process that dies again and again ends the run with status 7 and its last words") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"),
                  ProgramsWithScript(temporary.path() / "bin", "ronda-actor",
                                     "echo the actor cannot go on >&2\nexit 1\n"));

  CHECK(run.WaitForEnd(seconds(60)).code == 7);
  INFO(run.Output());
  CHECK(run.Output().find("5 deaths") != std::string::npos);
  CHECK(run.Output().find("the actor cannot go on") != std::string::npos);
}

TEST_CASE("A learner that says that its loss diverged ends the run with its status at once") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"),
                  ProgramsWithScript(temporary.path() / "bin", "ronda-learner",
                                     "echo the loss is not finite >&2\nexit 6\n"));

  CHECK(run.WaitForEnd(seconds(60)).code == 6);
  INFO(run.Output());
  CHECK(run.Output().find("the loss is not finite") != std::string::npos);
  CHECK(run.Summary()["restarts"]["learner"] == 0);
}

TEST_CASE("A program that misses a shared library ends the run at once and names the library") {
  const TemporaryFolder temporary;
  const auto ronda = ProgramsWithScript(temporary.path() / "bin", "ronda-replay", "");
  std::filesystem::copy_file(RONDA_LACKING_PROGRAM, temporary.path() / "bin" / "ronda-replay",
                             std::filesystem::copy_options::overwrite_existing);
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"), ronda);

  CHECK(run.WaitForEnd(seconds(60)).code == 7);
  INFO(run.Output());
  CHECK(Says(run, "cannot be loaded"));
  CHECK(Says(run, "libronda_test_gone.so"));
  CHECK(run.Summary()["restarts"]["replay"] == 0);
}

TEST_CASE("A full disk is said, the run goes on, and what was not kept is written later") {
  const TemporaryFolder temporary;
  LaunchedRun run(temporary.path() / "run", TrainFourNodes("1000000000"));
  REQUIRE(GoesOn(run));

  FillDiskFor(run.folder() / "state.json");
  CHECK(WaitUntil([&] { return Says(run, "state.json is not kept"); }, seconds(30)));
  CHECK(Says(run, "No space left on device"));
  CHECK(WaitUntil([&] { return Says(run, "state.json is written again"); }, seconds(30)));
  CHECK(GoesOn(run));

  run.Signal(SIGTERM);
  CHECK(run.WaitForEnd(seconds(30)).code == 128 + SIGTERM);
  CheckCounts(run.Summary());
}

TEST_CASE(
    "A learner that cannot write its last checkpoint ends the run with status 5 and says why") {
  const TemporaryFolder temporary;
  auto arguments = TrainFourNodes("1000000000");
  arguments.insert(arguments.end(), {"--set", "learner.checkpoint_every_s=600"});
  LaunchedRun run(temporary.path() / "run", arguments);
  REQUIRE(GoesOn(run));

  for (const char* file : {"learner.checkpoint", "latest.ronda"}) {
    FillDiskFor(run.folder() / "checkpoints" / file);
  }
  run.Signal(SIGTERM);

  CHECK(run.WaitForEnd(seconds(30)).code == 5);
  INFO(run.Output());
  CHECK(Says(run, "learner ended with exit status 5"));
  CHECK(Says(run, "No space left on device"));
  CheckCounts(run.Summary());
}

TEST_CASE("A run folder that cannot be made is refused with the reason") {
  const TemporaryFolder temporary;
  std::ofstream(temporary.path() / "file") << "no folder";
  auto arguments = TrainFourNodes("1000");
  std::ranges::replace(arguments, "{run}", (temporary.path() / "file" / "run").string());
  LaunchedRun run(temporary.path() / "run", arguments);

  CHECK(run.WaitForEnd(seconds(20)).code == 3);
  CHECK(Says(run, "the run folder cannot be made or written: Not a directory"));
}

TEST_CASE("Ports that are in use cost a run its domain or nothing") {
  const TemporaryFolder temporary;
  const auto folder = temporary.path() / "run";
  const std::uint64_t hint = std::hash<std::string>{}(folder.string());
  const RunDomain taken(hint);  // the one that the run would take
  const int next = RunDomain(hint).domain();
  // Another program on the first UDP port of the next one.
  const FileDescriptor other(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * next + 10));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  REQUIRE(::bind(other.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);

  LaunchedRun run(folder, TrainFourNodes("20000"));

  CHECK(run.WaitForEnd(seconds(120)).code == 0);
  INFO(run.Output());
  CHECK(Says(run, fmt::format("(DDS domain {})", next)));
  CheckCounts(run.Summary());
}

TEST_CASE("Several runs at once on one machine do not meet") {
  const TemporaryFolder temporary;
  std::vector<std::unique_ptr<LaunchedRun>> runs;
  for (const char* name : {"a", "b", "c"}) {
    runs.push_back(std::make_unique<LaunchedRun>(temporary.path() / name, TrainFourNodes("20000")));
  }

  std::set<int> domains;
  for (const auto& run : runs) {
    CHECK(run->WaitForEnd(seconds(200)).code == 0);
    CheckCounts(run->Summary());
    CHECK(run->Summary()["transitions_lost"] == 0);
    domains.insert(run->Status()["domain"].get<int>());
  }
  CHECK(domains.size() == 3);
}

TEST_CASE("32 actors start, work and stop") {
  const TemporaryFolder temporary;
  auto arguments = TrainFourNodes("1000000000");
  *(std::ranges::find(arguments, "--actors") + 1) = "32";
  LaunchedRun run(temporary.path() / "run", arguments);

  CHECK(WaitUntil(
      [&] {
        const auto status = run.Status();
        if (status.is_null()) return false;
        const auto& processes = status["processes"];
        return processes.size() == 34 && std::ranges::all_of(processes, [](const auto& process) {
                 return process["role"] != "actor" || process["weights_version"] > 0;
               });
      },
      seconds(100)));
  REQUIRE(GoesOn(run));

  run.Signal(SIGTERM);
  CHECK(run.WaitForEnd(seconds(50)).code == 128 + SIGTERM);
  CheckCounts(run.Summary());
  CHECK(run.Summary()["transitions_lost"] == 0);
}

}  // namespace
}  // namespace ronda
