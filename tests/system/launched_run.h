#pragma once
// A `ronda` that a test has started, in a run folder of its own, with what it printed and wrote.
//
// Ended (SIGKILL) by the destructor if it still runs. All waits have limits, far above what is
// needed. Thread-compatible.
#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/run/child_process.h"
#include "tests/temporary_folder.h"

namespace ronda {

/// Waits until `condition` holds; false where it does not within the limit.
bool WaitUntil(const std::function<bool()>& condition, std::chrono::seconds at_most);

/// Processes that are children of `parent` and have this name (cut to 15 characters, as the kernel
/// keeps it).
std::vector<pid_t> ChildrenNamed(pid_t parent, const std::string& name);

bool IsAlive(pid_t pid);

class LaunchedRun {
 public:
  /// `ronda ARGUMENTS…`; `{run}` in an argument stands for the run folder.
  LaunchedRun(const std::filesystem::path& run_folder, std::vector<std::string> arguments,
              const std::filesystem::path& program = std::filesystem::path(RONDA_BIN_DIR) /
                                                     "ronda");

  pid_t pid() const { return child_.pid(); }
  void Signal(int signal) { child_.Signal(signal); }
  /// How it ended; the test fails where it has not by then.
  ExitStatus WaitForEnd(std::chrono::seconds at_most);
  std::optional<ExitStatus> Poll() { return child_.Poll(); }

  std::string Output() const;               // stdout and stderr so far
  nlohmann::json Status() const;            // status.json; null where there is none
  nlohmann::json Summary() const;           // summary.json; null where there is none
  nlohmann::json State() const;             // state.json; null where there is none
  std::uint64_t StoredTransitions() const;  // as of the last status.json
  std::uint64_t WeightsVersion() const;
  const std::filesystem::path& folder() const { return run_folder_; }

 private:
  std::filesystem::path run_folder_;
  std::filesystem::path output_;
  ChildProcess child_;
};

/// `ronda train` on the 4-node map with 2 robots and 2 actors, in the folder {run}.
std::vector<std::string> TrainFourNodes(const std::string& decisions);

/// From now on transitions are stored and weights published: the whole circle works.
bool GoesOn(const LaunchedRun& run);

/// What must hold of every run's summary, whatever happened.
void CheckCounts(const nlohmann::json& summary);

/// A folder with the real programs, but for one that is a script; the path of its `ronda`.
std::filesystem::path ProgramsWithScript(const std::filesystem::path& folder,
                                         const std::string& replaced, const std::string& script);

}  // namespace ronda
