#include "common/evaluation/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "common/evaluation/report_json.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json OrNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// All but speed and noise, which stand for themselves.
Json ConditionsAsJson(const Conditions& conditions) {
  const Communication& communication = conditions.communication;
  const Attrition& attrition = conditions.attrition;
  Json json;
  json["label"] = Label(conditions);
  json["message_loss"] = communication.loss();
  json["message_range_m"] = OrNull(communication.message_range_m);
  json["message_delay_s"] = communication.message_delay_s;
  json["observation_radius_m"] = OrNull(communication.observation_radius_m);
  json["changes"] = Json::array();
  for (const RobotChange& change : attrition.changes) {
    json["changes"].push_back({{"robot", change.robot},
                               {"time_s", change.time_s},
                               {"event", change.joins ? "join" : "fail"}});
  }
  json["mean_time_to_failure_s"] = OrNull(attrition.mean_time_to_failure_s);
  json["repair_s"] = OrNull(attrition.repair_s);
  json["priorities"] = Json::object();
  for (const auto& [vertex, priority] : conditions.priorities) {
    json["priorities"][vertex] = priority;
  }
  json["stay_s"] = conditions.stay_s;
  return json;
}

std::string FormatConditions(const Conditions& conditions) {
  Conditions others = conditions;
  others.speeds_mps = Conditions().speeds_mps;
  const std::string label = Label(others);
  return fmt::format("at {:g} m/s{}{}", fmt::join(conditions.speeds_mps, "/"),
                     label.empty() ? "" : ", ", label);
}

std::string FormatProtocol(const EvaluationReport& report) {
  const EvaluationResult& result = report.result;
  if (report.options.protocol == Protocol::kThesis) {
    return fmt::format("thesis protocol: from zero idleness, horizon {:.6g} s, no warm-up",
                       result.window_s);
  }
  return fmt::format(
      "steady protocol: warm-up {:.6g} s ({:g} T_ref), window {:.6g} s ({:g} T_ref), T_ref {:.6g} "
      "s",
      result.warmup_s, kWarmupTref, result.window_s, kWindowTref, result.t_ref_s);
}

}  // namespace

Json EstimateAsJson(const Estimate& estimate) {
  Json json;
  json["mean"] = estimate.mean;
  json["ci95"] = estimate.ci95 ? Json(*estimate.ci95) : Json(nullptr);
  return json;
}

Json TeamAsJsonValue(const std::string& map, const EvaluationOptions& options) {
  const std::vector<double>& speeds_mps = options.conditions.speeds_mps;
  Json json;
  json["map"] = map;
  json["agents"] = options.agents;
  json["speed_mps"] = speeds_mps.size() == 1 ? Json(speeds_mps.front()) : Json(speeds_mps);
  json["noise"] = options.conditions.travel_noise;
  json["conditions"] = ConditionsAsJson(options.conditions);
  return json;
}

Json ReportAsJsonValue(const EvaluationReport& report) {
  const EvaluationResult& result = report.result;
  Json json = TeamAsJsonValue(report.map, report.options);
  json[KindName(report.contestant.kind)] = report.contestant.name;
  json["seed"] = report.options.seed;
  json["protocol"] = ProtocolName(report.options.protocol);
  json["episodes"] = result.episodes.size();
  json["t_ref_s"] = result.t_ref_s;
  json["warmup_s"] = result.warmup_s;
  json["window_s"] = result.window_s;
  json["decisions"] = result.decisions();
  json["agi_s"] = EstimateAsJson(MeanWithInterval(result.agi_s()));
  json["wi_s"] = EstimateAsJson(MeanWithInterval(result.wi_s()));
  json["final_s"] = EstimateAsJson(MeanWithInterval(result.final_s()));
  if (report.ratio_to_random) json["ratio_to_random"] = *report.ratio_to_random;
  json["lower_bound_agi_s"] = report.bounds ? Json(report.bounds->agi_s) : Json(nullptr);
  json["lower_bound_wi_s"] = report.bounds ? Json(report.bounds->wi_s) : Json(nullptr);
  return json;
}

std::optional<LowerBounds> BoundsOf(const StrategyContext& context,
                                    const EvaluationOptions& options) {
  if (options.conditions.attrition.repair_s) return std::nullopt;
  return ComputeLowerBounds(*context.graph, *context.paths,
                            {.speeds_mps = SpeedsOf(options.conditions, options.agents),
                             .staying = options.conditions.stay_s > 0.0});
}

std::string ReportAsJson(const EvaluationReport& report) {
  return ReportAsJsonValue(report).dump(2, ' ', false, Json::error_handler_t::replace);
}

const char* KindName(ContestantKind kind) {
  return kind == ContestantKind::kPolicy ? "policy" : "strategy";
}

std::string FormatSeconds(double seconds) {
  return fmt::format("{:.{}f}", seconds, seconds < 1.0 ? 4 : 2);
}

std::string FormatEstimate(const Estimate& estimate) {
  if (!estimate.ci95) return FormatSeconds(estimate.mean);
  return fmt::format("{} ± {:.{}f}", FormatSeconds(estimate.mean), *estimate.ci95,
                     estimate.mean < 1.0 ? 4 : 2);
}

std::string FormatTeam(const std::string& map, const EvaluationOptions& options) {
  return fmt::format("{}, {} robot{} {}", map, options.agents, options.agents == 1 ? "" : "s",
                     FormatConditions(options.conditions));
}

std::string FormatSetting(const EvaluationReport& report) {
  return fmt::format("{}\n{}\n{} episode{}, seed {}; mean ± 95 % interval over episodes\n",
                     FormatTeam(report.map, report.options), FormatProtocol(report),
                     report.options.episodes, report.options.episodes == 1 ? "" : "s",
                     report.options.seed);
}

std::string FormatBoundsNote(const EvaluationReport& report) {
  return report.bounds
             ? "The bounds hold for unlimited time: a window may lie below them, a short one far.\n"
             : "No bound is known where robots are repaired.\n";
}

std::string FormatReport(const EvaluationReport& report) {
  const EvaluationResult& result = report.result;
  std::string text = FormatSetting(report);
  text += fmt::format("{} {}, {} decisions\n\n", KindName(report.contestant.kind),
                      report.contestant.name, result.decisions());
  const auto bound = [&](double LowerBounds::*value_s) {
    return report.bounds
               ? fmt::format("   lower bound {} s", FormatSeconds(*report.bounds.*value_s))
               : "";
  };
  text += fmt::format("  average graph idleness  {:>20} s{}\n",
                      FormatEstimate(MeanWithInterval(result.agi_s())), bound(&LowerBounds::agi_s));
  text += fmt::format("  worst idleness          {:>20} s{}\n",
                      FormatEstimate(MeanWithInterval(result.wi_s())), bound(&LowerBounds::wi_s));
  text += fmt::format("  final idleness          {:>20} s\n",
                      FormatEstimate(MeanWithInterval(result.final_s())));
  if (report.ratio_to_random) {
    text += fmt::format("  random walk's final idleness over this one's: {:.2f}\n",
                        *report.ratio_to_random);
  }
  return text + "\n" + FormatBoundsNote(report);
}

}  // namespace ronda
