#include "common/evaluation/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/evaluation/report_json.h"

namespace ronda {
namespace {

using Json = nlohmann::ordered_json;

Json SampleAsJson(const std::vector<double>& values) {
  Json json = EstimateAsJson(MeanWithInterval(values));
  const auto deviation = StandardDeviation(values);
  json["sd"] = deviation ? Json(*deviation) : Json(nullptr);
  return json;
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

Json SettingAsJson(const EvaluationReport& report) {
  Json json;
  json["map"] = report.map;
  json["agents"] = report.options.agents;
  json[KindName(report.contestant.kind)] = report.contestant.name;
  json["speed_mps"] = report.options.speed_mps;
  json["noise"] = report.options.travel_noise;
  json["seed"] = report.options.seed;
  json["protocol"] = ProtocolName(report.options.protocol);
  json["episodes"] = report.options.episodes;
  return json;
}

Json ReportAsJsonValue(const EvaluationReport& report) {
  const EvaluationResult& result = report.result;
  Json json = SettingAsJson(report);
  json["t_ref_s"] = result.t_ref_s;
  json["warmup_s"] = result.warmup_s;
  json["window_s"] = result.window_s;
  json["decisions"] = result.decisions();
  json["agi_s"] = SampleAsJson(result.agi_s());
  json["wi_s"] = SampleAsJson(result.wi_s());
  json["final_s"] = SampleAsJson(result.final_s());
  if (report.ratio_to_random) json["ratio_to_random"] = *report.ratio_to_random;
  json["lower_bound_agi_s"] = report.bounds.agi_s;
  json["lower_bound_wi_s"] = report.bounds.wi_s;
  return json;
}

std::string ReportAsJson(const EvaluationReport& report) {
  return ReportAsJsonValue(report).dump(2, ' ', false, Json::error_handler_t::replace);
}

const char* KindName(ContestantKind kind) {
  return kind == ContestantKind::kPolicy ? "policy" : "strategy";
}

std::string ConditionLabel(const EvaluationOptions& options) {
  return options.travel_noise > 0.0 ? fmt::format("noise {}", options.travel_noise) : "";
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
      "{}, {} robot{} at {:g} m/s, noise {:g}\n{}\n{} episode{}, seed {}; mean ± 95 % interval "
      "over "
      "episodes\n",
      report.map, report.options.agents, report.options.agents == 1 ? "" : "s",
      report.options.speed_mps, report.options.travel_noise, FormatProtocol(report),
      report.options.episodes, report.options.episodes == 1 ? "" : "s", report.options.seed);
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
