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
  nlohmann::json Summary() const;           // summary.json; null where there is none
  nlohmann::json State() const;             // state.json; null where there is none
  std::uint64_t StoredTransitions() const;  // as of the last state.json
  std::uint64_t WeightsVersion() const;
  const std::filesystem::path& folder() const { return run_folder_; }

 private:
  std::filesystem::path run_folder_;
  std::filesystem::path output_;
  ChildProcess child_;
};

}  // namespace ronda
