#include "deploy/run_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "deploy/totals_json.h"

namespace ronda {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BestPolicy, agi_s, second_half)

RunState ReadRunState(const std::filesystem::path& run_folder) {
  const auto path = run_folder / "state.json";
  std::ifstream file(path);
  RunState state;
  if (!file) return state;
  try {
    const Json json = Json::parse(file);
    state.begun_unix_s = json.value("begun_unix_s", 0.0);
    json.at("totals").get_to(state.totals);
    json.at("training_s").get_to(state.training_s);
    json.at("wall_s").get_to(state.wall_s);
    json.at("updates").get_to(state.updates);
    json.at("restarts").get_to(state.restarts);
    if (json.contains("best")) state.best = json.at("best").get<BestPolicy>();
  } catch (const Json::exception& error) {
    throw CheckpointError(
        fmt::format("{}: not the state of a run: {}", path.string(), error.what()));
  }
  return state;
}

void WriteRunState(const std::filesystem::path& run_folder, const RunState& state) {
  Json json{{"begun_unix_s", state.begun_unix_s}, {"totals", state.totals},
            {"training_s", state.training_s},     {"wall_s", state.wall_s},
            {"updates", state.updates},           {"restarts", state.restarts}};
  if (state.best) json["best"] = *state.best;
  WriteWholeFile(run_folder / "state.json", json.dump(1) + "\n");
}

double Progress(const RunConfig& run, double training_s, std::uint64_t decisions) {
  const double by_time = run.budget_s > 0.0 ? training_s / run.budget_s : 0.0;
  const double by_decisions =
      run.budget_decisions > 0
          ? static_cast<double>(decisions) / static_cast<double>(run.budget_decisions)
          : 0.0;
  return std::max(by_time, by_decisions);
}

}  // namespace ronda
