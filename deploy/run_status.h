#pragma once
// The present picture of a run, as `ronda train` shows it and leaves it for other commands.
//
// Kept in `status.json` of the run folder, replaced as a whole twice a second while the run goes
// (not synced to the disk: it is of no use after a crash of the machine), and once at its end.
// A file that is not ours is InputError with the reason. Plain values; the JSON has the names of
// the fields.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "deploy/transition_ledger.h"

namespace ronda {

inline constexpr double kSilentAfterS =
    5.0;  // who tells of itself several times a second, normally

/// "actor 2", "replay", "learner".
std::string ProcessName(const std::string& role, std::uint32_t index);

struct ProcessStatus {
  std::string role;  // replay, learner, actor
  std::uint32_t index = 0;
  std::int64_t pid = 0;  // 0: none at present
  /// "starting", "running", "waiting for …", "leaving", "dead, starting again in 1.2 s"
  std::string state;
  std::map<std::string, double> rates_per_s;  // {"decisions", 21000.0}
  /// Of an actor's weights behind the newest; of the learner's samples behind its weights.
  std::optional<double> lag_versions;
  std::uint64_t weights_version = 0;  // that it acts with or published; 0: none yet, or the replay
  int restarts = 0;
  std::string last_error;  // how its last death came about; empty: none
  double silent_s = 0.0;   // since its last report, or its start
};

struct ChannelStatus {
  std::string topic;  // "experience"
  std::string from;   // "actors"
  std::string to;     // "replay"
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  double messages_per_s = 0.0;
  double bytes_per_s = 0.0;
  std::string waiting;  // "2 actors wait for room in the replay"; empty: nobody waits
};

struct CurvePoint {
  double training_s = 0.0;
  double agi_s = 0.0;
};

struct RunEvent {
  double unix_s = 0.0;
  std::string text;  // one line
};

struct RunStatus {
  std::string map;
  int agents = 0;
  std::string algorithm;
  /// "starting" (nothing stored yet), "running", "stopping"; at the end "finished" (its budget is
  /// used), "stopped" (by a signal), "failed" (exit_status says how)
  std::string state;
  std::optional<int> exit_status;  // at the end
  std::int64_t launcher_pid = 0;
  int domain = 0;
  std::string run_id;
  double begun_unix_s = 0.0;    // the folder's first session
  double written_unix_s = 0.0;  // this picture

  double progress = 0.0;  // share of the budget, 0 … 1
  double training_s = 0.0;
  std::optional<double> left_s;
  std::uint64_t updates = 0;
  double decisions_per_s = 0.0;
  double updates_per_s = 0.0;
  std::uint64_t replay_size = 0;
  std::uint64_t replay_capacity = 0;
  RunTotals totals;
  int actors_wanted = 0;

  std::vector<CurvePoint> curve;  // evaluations of the policy, oldest first
  std::optional<double> best_agi_s;
  std::string best_classical;  // its name; empty: not known yet
  std::optional<double> best_classical_agi_s;
  std::optional<double> lower_bound_agi_s;

  std::vector<ProcessStatus> processes;  // replay, learner, actors by index
  std::vector<ChannelStatus> channels;
  std::vector<RunEvent> events;       // the last ones, oldest first
  std::vector<std::string> problems;  // why the run is degraded, a sentence each; empty: healthy
};

std::string RunStatusAsJson(const RunStatus& status);
void WriteRunStatus(const std::filesystem::path& run_folder, const RunStatus& status);
/// nullopt where the folder has none.
std::optional<RunStatus> ReadRunStatus(const std::filesystem::path& run_folder);

}  // namespace ronda
