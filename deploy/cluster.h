#pragma once
// The child processes of a run: one replay, one learner, K actors; started, watched, restarted,
// stopped.
//
// A child that dies is reported with its exit status and last log lines and started again after a
// while (run/restart_policy). A status that a restart cannot mend (a wrong configuration,
// divergence) ends the run with that status, a crash loop with 7. Thread-compatible; use it from
// the main thread only (see run/child_process).
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/run/child_process.h"
#include "common/run/restart_policy.h"

namespace ronda {

enum class Role { kReplay, kLearner, kActor };
const char* RoleName(Role role);  // "replay", "learner", "actor"

struct ClusterOptions {
  std::filesystem::path program_folder;
  std::filesystem::path run_folder;
  std::filesystem::path config_file;
  int domain = 0;
  std::string run_id;
  std::uint32_t actors = 1;
  std::uint64_t first_incarnation = 1;
};

/// A child ended that was not asked to.
struct Death {
  Role role = Role::kActor;
  std::uint32_t index = 0;
  std::uint64_t incarnation = 0;
  std::string description;           // one line: who, how
  std::vector<std::string> log;      // its last lines
  std::optional<int> run_ends_with;  // the exit status, where the run cannot go on
};

class Cluster {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Starts all children. `weights_version` is asked for whenever the learner is started.
  Cluster(const ClusterOptions& options, std::function<std::uint64_t()> weights_version);

  /// Restarts what is due; returns who has died since the last call.
  std::vector<Death> Supervise(TimePoint now);

  /// Actors and learner first, while the replay still takes what actors hold; then the replay. What
  /// has not ended after `grace` each time is killed; names of those are returned. `while_waiting`
  /// is called often.
  std::vector<std::string> Stop(std::chrono::milliseconds grace,
                                const std::function<void()>& while_waiting);

  int restarts(Role role) const;

 private:
  struct Member {
    Role role = Role::kActor;
    std::uint32_t index = 0;
    RestartPolicy policy;
    std::optional<ChildProcess> child;
    std::uint64_t incarnation = 0;
    int starts = 0;
    TimePoint started;
    std::optional<TimePoint> start_again;

    std::string Name() const;
  };

  void Start(Member& member, TimePoint now);
  std::filesystem::path LogFile(const Member& member) const;
  Death Bury(Member& member, const ExitStatus& status, TimePoint now);
  void StopRoles(const std::function<bool(Role)>& chosen, std::chrono::milliseconds grace,
                 const std::function<void()>& while_waiting, std::vector<std::string>& killed);

  ClusterOptions options_;
  std::function<std::uint64_t()> weights_version_;
  std::uint64_t next_incarnation_;
  std::vector<Member> members_;
};

}  // namespace ronda
