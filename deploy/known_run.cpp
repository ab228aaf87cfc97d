#include "deploy/known_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/run/run_config.h"
#include "common/run/run_folder.h"
#include "common/run/unix_time.h"

namespace ronda {
namespace {

/// Of a run that has left no picture: a launcher that has just begun.
RunStatus FromConfiguration(const std::filesystem::path& config_file) {
  Config config = Config::FromFile(config_file);
  const RunConfig run = ReadRunConfig(config);
  RunStatus status;
  status.map = run.map;
  status.agents = run.agents;
  status.algorithm = run.algorithm;
  status.actors_wanted = run.actors;
  status.state = "starting";
  return status;
}

bool HasEnded(const RunStatus& status) {
  return status.state == "finished" || status.state == "stopped" || status.state == "failed";
}

/// Nothing of it moves any more.
void StandStill(RunStatus& status) {
  status.processes.clear();
  status.decisions_per_s = 0.0;
  status.updates_per_s = 0.0;
  for (ChannelStatus& channel : status.channels) {
    channel.messages_per_s = 0.0;
    channel.bytes_per_s = 0.0;
    channel.waiting.clear();
  }
}

}  // namespace

void Judge(std::optional<pid_t> launcher, double now_unix_s, RunStatus& status) {
  if (!launcher) {
    StandStill(status);
    if (HasEnded(status)) return;
    status.state = "abandoned";
    status.problems = {"its launcher ended without a word; the same command goes on"};
    return;
  }
  if (status.launcher_pid != *launcher) {  // the picture is a former launcher's
    status.state = "starting";
    status.launcher_pid = *launcher;
    status.exit_status.reset();
    status.processes.clear();
    status.problems.clear();
    return;
  }
  const double silent_s = now_unix_s - status.written_unix_s;
  if (silent_s > kSilentAfterS && !HasEnded(status)) {
    status.problems.push_back(
        fmt::format("the launcher (process {}) has been silent for {:.0f} s", *launcher, silent_s));
  }
}

KnownRun FindRun(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError(
        fmt::format("{}: no such run; `ronda runs` lists those that there are", folder.string()));
  }
  if (!std::filesystem::is_regular_file(folder / "config.toml", error)) {
    throw InputError(fmt::format("{}: no run's folder: it has no config.toml", folder.string()));
  }
  KnownRun run{.folder = folder, .launcher = RunFolder::Holder(folder), .status = {}};
  const auto picture = ReadRunStatus(folder);
  run.status = picture ? *picture : FromConfiguration(folder / "config.toml");
  Judge(run.launcher, UnixNow(), run.status);
  return run;
}

std::vector<KnownRun> FindRuns(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(root, error)) {
    if (std::filesystem::is_regular_file(entry.path() / "config.toml", error)) {
      folders.push_back(entry.path());
    }
  }
  std::ranges::sort(folders);
  std::vector<KnownRun> runs;
  for (const auto& folder : folders) {
    try {
      runs.push_back(FindRun(folder));
    } catch (const Error& unreadable) {  // one bad folder hides no other
      KnownRun& run = runs.emplace_back();
      run.folder = folder;
      run.status.state = "unreadable";
      run.status.problems = {unreadable.what()};
    }
  }
  return runs;
}

}  // namespace ronda
