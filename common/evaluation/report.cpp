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

Json ReportAsJsonValue(const EvaluationReport& report) {
  const EvaluationResult& result = report.result;
  Json json;
  json["map"] = report.map;
  json["agents"] = report.options.agents;
  json[KindName(report.contestant.kind)] = report.contestant.name;
  const std::vector<double>& speeds_mps = report.options.conditions.speeds_mps;
  json["speed_mps"] = speeds_mps.size() == 1 ? Json(speeds_mps.front()) : Json(speeds_mps);
  json["noise"] = report.options.conditions.travel_noise;
  json["conditions"] = ConditionsAsJson(report.options.conditions);
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
  json["lower_bound_agi_s"] = report.bounds.agi_s;
  json["lower_bound_wi_s"] = report.bounds.wi_s;
  return json;
}

LowerBounds BoundsOf(const PatrolGraph& graph, const EvaluationOptions& options) {
  return ComputeLowerBounds(graph, TotalSpeed_mps(options.conditions, options.agents),
                            options.agents);
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

std::string FormatSetting(const EvaluationReport& report) {
  return fmt::format(
      "{}, {} robot{} {}\n{}\n{} episode{}, seed {}; mean ± 95 % interval over episodes\n",
      report.map, report.options.agents, report.options.agents == 1 ? "" : "s",
      FormatConditions(report.options.conditions), FormatProtocol(report), report.options.episodes,
      report.options.episodes == 1 ? "" : "s", report.options.seed);
}

std::string FormatReport(const EvaluationReport& report) {
  const EvaluationResult& result = report.result;
  std::string text = FormatSetting(report);
  text += fmt::format("{} {}, {} decisions\n\n", KindName(report.contestant.kind),
                      report.contestant.name, result.decisions());
  text += fmt::format("  average graph idleness  {:>20} s   lower bound {} s\n",
                      FormatEstimate(MeanWithInterval(result.agi_s())),
                      FormatSeconds(report.bounds.agi_s));
  text += fmt::format("  worst idleness          {:>20} s   lower bound {} s\n",
                      FormatEstimate(MeanWithInterval(result.wi_s())),
                      FormatSeconds(report.bounds.wi_s));
  text += fmt::format("  final idleness          {:>20} s\n",
                      FormatEstimate(MeanWithInterval(result.final_s())));
  if (report.ratio_to_random) {
    text += fmt::format("  random walk's final idleness over this one's: {:.2f}\n",
                        *report.ratio_to_random);
  }
  text += "\nThe bounds hold for unlimited time: a finite window may lie a little below them.\n";
  return text;
}

}  // namespace ronda
