#include "deploy/run_status.h"

#include <fmt/format.h>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "deploy/totals_json.h"

namespace ronda {
namespace {

std::filesystem::path StatusFile(const std::filesystem::path& run_folder) {
  return run_folder / "status.json";
}

}  // namespace

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProcessStatus, role, index, pid, state, rates_per_s,
                                   lag_versions, weights_version, restarts, last_error, silent_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChannelStatus, topic, from, to, messages, bytes, messages_per_s,
                                   bytes_per_s, waiting)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurvePoint, training_s, agi_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunEvent, unix_s, text)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunStatus, map, agents, algorithm, state, exit_status,
                                   launcher_pid, domain, run_id, begun_unix_s, written_unix_s,
                                   progress, training_s, left_s, updates, decisions_per_s,
                                   updates_per_s, replay_size, replay_capacity, totals,
                                   actors_wanted, curve, best_agi_s, best_classical,
                                   best_classical_agi_s, lower_bound_agi_s, processes, channels,
                                   events, problems)

std::string ProcessName(const std::string& role, std::uint32_t index) {
  return role == "actor" ? fmt::format("actor {}", index) : role;
}

std::string RunStatusAsJson(const RunStatus& status) {
  return nlohmann::json(status).dump(1) + "\n";
}

void WriteRunStatus(const std::filesystem::path& run_folder, const RunStatus& status) {
  WriteWholeFile(StatusFile(run_folder), RunStatusAsJson(status), Sync::kNo);
}

std::optional<RunStatus> ReadRunStatus(const std::filesystem::path& run_folder) {
  const auto path = StatusFile(run_folder);
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    return nlohmann::json::parse(ReadWholeFile(path)).get<RunStatus>();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not the status of a run: {}", path.string(), error.what()));
  }
}

}  // namespace ronda
