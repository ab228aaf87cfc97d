#pragma once
// What another command can know of a run: its folder, who holds it, and its last picture, judged.
//
// Reads only; nothing that a running launcher would notice. InputError (status 3) where the folder
// is no run's, with what is missing.
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "deploy/run_status.h"

namespace ronda {

struct KnownRun {
  std::filesystem::path folder;
  std::optional<pid_t> launcher;  // nullopt: no process holds the folder
  RunStatus status;               // judged: see Judge
};

KnownRun FindRun(const std::filesystem::path& folder);
/// Those below `root`, by name; what is no run's folder is passed over, and a run that cannot be
/// read is "unreadable", with the reason as its problem.
std::vector<KnownRun> FindRuns(const std::filesystem::path& root);

/// What the picture says, seen from outside at `now_unix_s`: a run that nobody holds and that has
/// not said how it ended is "abandoned", one whose launcher is silent has a problem.
void Judge(std::optional<pid_t> launcher, double now_unix_s, RunStatus& status);

}  // namespace ronda
