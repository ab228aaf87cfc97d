#include "deploy/run_state.h"

#include <fmt/format.h>

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
  Json json{{"totals", state.totals},
            {"training_s", state.training_s},
            {"wall_s", state.wall_s},
            {"updates", state.updates},
            {"restarts", state.restarts}};
  if (state.best) json["best"] = *state.best;
  WriteWholeFile(run_folder / "state.json", json.dump(1) + "\n");
}

}  // namespace ronda
