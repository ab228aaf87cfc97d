#include "deploy/summary.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/evaluation/report.h"
#include "common/run/duration.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

Json EstimateAsJson(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  return {{"mean", estimate->mean},
          {"ci95", estimate->ci95 ? Json(*estimate->ci95) : Json(nullptr)}};
}

}  // namespace

std::string SummaryAsJson(const RunSummary& summary, const RunConfig& run) {
  const RunState& state = summary.state;
  const RunTotals& totals = state.totals;
  Json json{{"map", run.map},
            {"agents", run.agents},
            {"algorithm", run.algorithm},
            {"seed", run.seed},
            {"wall_s", state.wall_s},
            {"training_s", state.training_s},
            {"decisions", totals.decisions},
            {"updates", state.updates},
            {"transitions_sent", totals.sent},
            {"transitions_stored", totals.stored},
            {"transitions_in_flight", totals.in_flight},
            {"transitions_lost", totals.lost},
            {"transitions_doubled", totals.doubled},
            {"transitions_forgotten", totals.forgotten},
            {"messages_refused", totals.messages_refused},
            {"weights_version", totals.weights_version},
            {"restarts", state.restarts},
            {"agi_s", EstimateAsJson(summary.agi_s)}};
  std::optional<Estimate> classical;
  if (summary.yardstick) classical = summary.yardstick->agi_s;
  json["best_classical_agi_s"] = EstimateAsJson(classical);
  json["best_classical"] = summary.yardstick ? Json(summary.yardstick->strategy) : Json(nullptr);
  const bool bounded = summary.yardstick && summary.yardstick->bounds;
  json["lower_bound_agi_s"] = bounded ? Json(summary.yardstick->bounds->agi_s) : Json(nullptr);
  return json.dump(1) + "\n";
}

std::string FormatSummary(const RunSummary& summary, const RunConfig& run,
                          const std::string& run_folder) {
  const RunState& state = summary.state;
  const RunTotals& totals = state.totals;
  std::string text = fmt::format(
      "\n{}: {} robots on {}, {} of training, {} decisions, {} updates\n", run_folder, run.agents,
      run.map, FormatDuration(state.training_s), totals.decisions, state.updates);
  text += fmt::format(
      "transitions: {} sent = {} stored + {} lost + {} in flight; {} doubled, {} forgotten; {} "
      "messages refused\n",
      totals.sent, totals.stored, totals.lost, totals.in_flight, totals.doubled, totals.forgotten,
      totals.messages_refused);
  text += fmt::format("restarts: actor {}, replay {}, learner {}\n", state.restarts.at("actor"),
                      state.restarts.at("replay"), state.restarts.at("learner"));
  if (summary.agi_s) {
    text += fmt::format("AGI of the best policy: {} s (steady protocol, 20 episodes, seed 1)\n",
                        FormatEstimate(*summary.agi_s));
  } else {
    text += "AGI of the best policy: not judged\n";
  }
  if (summary.yardstick) {
    const auto& bounds = summary.yardstick->bounds;
    text += fmt::format("best classical strategy: {}, {} s; lower bound {}\n",
                        summary.yardstick->strategy, FormatEstimate(summary.yardstick->agi_s),
                        bounds ? fmt::format("{:.3f} s", bounds->agi_s) : "none");
  }
  return text;
}

}  // namespace ronda
