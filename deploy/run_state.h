#pragma once
// What a run folder remembers between its sessions: totals, training time, and its best policy so
// far.
//
// Kept in `state.json`, replaced as a whole every few seconds, so that a launcher that is killed
// loses a few seconds of counting at most. A file that is not ours is CheckpointError with the
// reason.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "common/run/run_config.h"
#include "deploy/transition_ledger.h"

namespace ronda {

struct BestPolicy {
  double agi_s = 0.0;  // on the evaluation seeds
  bool second_half =
      false;  // found in the second half of the budget: preferred to any of the first
};

struct RunState {
  double begun_unix_s = 0.0;  // when the folder's first session did
  RunTotals totals;
  double training_s = 0.0;  // since the first transition, over all sessions
  double wall_s = 0.0;
  std::uint64_t updates = 0;
  std::map<std::string, int> restarts;  // by role
  std::optional<BestPolicy> best;
};

/// A new state where the folder has none.
RunState ReadRunState(const std::filesystem::path& run_folder);
void WriteRunState(const std::filesystem::path& run_folder, const RunState& state);

/// Share of the budget that is used: the larger of the two shares; 0 where there is no limit.
double Progress(const RunConfig& run, double training_s, std::uint64_t decisions);

}  // namespace ronda
