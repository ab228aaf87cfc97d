#pragma once
// The child processes of a run: one replay, one learner, K actors; started, watched, restarted,
// added, dismissed, stopped.
//
// A child that dies is reported with its exit status and last log lines and started again after a
// while (run/restart_policy). A status that a restart cannot mend (a wrong configuration,
// divergence, a program that cannot be loaded) ends the run with that status, a crash loop with 7.
// K can change at any time: actors with the highest indices are asked to leave, and end when what
// they have sent is stored. Thread-compatible; use it from the main thread only (see
// run/child_process).
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <map>
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

/// A child ended: by itself, or (an actor) because it was asked to leave.
struct Ending {
  Role role = Role::kActor;
  std::uint32_t index = 0;
  std::uint64_t incarnation = 0;
  std::string description;           // one line: who, how, what comes next
  std::vector<std::string> log;      // its last lines; empty where it left as asked
  std::optional<int> run_ends_with;  // the exit status, where the run cannot go on
};

/// One child as its parent sees it.
struct ChildFacts {
  Role role = Role::kActor;
  std::uint32_t index = 0;
  pid_t pid = 0;  // 0: it is dead, and will be started again
  std::uint64_t incarnation = 0;
  int restarts = 0;
  bool leaving = false;
  std::string last_error;  // how its last death came about; empty: none
  std::chrono::steady_clock::time_point started;
  std::optional<std::chrono::steady_clock::time_point> start_again;
};

class Cluster {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Starts all children. `weights_version` is asked for whenever the learner is started.
  Cluster(const ClusterOptions& options, std::function<std::uint64_t()> weights_version);

  /// How many actors are wanted from now on, ≥ 1; Supervise brings it about.
  void set_actors(std::uint32_t wanted) { options_.actors = wanted; }

  /// Starts what is due or wanted, dismisses who is not; returns who has ended since the last call.
  std::vector<Ending> Supervise(TimePoint now);

  /// Actors and learner first, while the replay still takes what actors hold; then the replay. What
  /// has not ended after `grace` each time is killed. Returns those that did not end well.
  /// `while_waiting` is called often.
  std::vector<Ending> Stop(std::chrono::milliseconds grace,
                           const std::function<void()>& while_waiting);

  /// Replay, learner, actors in the order of their start.
  std::vector<ChildFacts> Children() const;
  int restarts(Role role) const;  // over all children that there were

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
    std::optional<TimePoint> kill_at;  // set when it was asked to leave
    std::string last_error;

    std::string Name() const;
  };

  void Add(Role role, std::uint32_t index, TimePoint now);
  void Start(Member& member, TimePoint now);
  void AddWantedActors(TimePoint now);
  void DismissUnwantedActors(TimePoint now);
  std::filesystem::path LogFile(const Member& member) const;
  Ending EndingOf(const Member& member) const;
  Ending Bury(Member& member, const ExitStatus& status, TimePoint now);
  Ending Farewell(Member& member, const ExitStatus& status);
  void StopRoles(const std::function<bool(Role)>& chosen, std::chrono::milliseconds grace,
                 const std::function<void()>& while_waiting, std::vector<Ending>& unwell);

  ClusterOptions options_;
  std::function<std::uint64_t()> weights_version_;
  std::uint64_t next_incarnation_;
  std::list<Member> members_;
  std::map<Role, int> restarts_;
};

}  // namespace ronda
