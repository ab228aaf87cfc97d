#include "deploy/bounds_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/evaluation/output_file.h"
#include "common/world/closed_walk_bound.h"
#include "deploy/evaluation_arguments.h"
#include "deploy/text_table.h"

namespace ronda {
namespace {

struct BoundsArguments : EvaluationArguments {
  bool staying = false;
};

/// What is known of a map and a team.
struct BoundsReport {
  BoundsArguments arguments;
  LowerBounds bounds;
  ClosedWalk walk;
  ClosedWalkBound walk_bound;
  double cyclic_wi_s = 0.0;  // robots evenly spaced on the walk: WI is at most this
};

std::string AsJson(const BoundsReport& report) {
  const EvaluationOptions& options = report.arguments.options;
  const LowerBounds& bounds = report.bounds;
  auto tried = nlohmann::ordered_json::array();
  const auto add = [&](const char* metric, const std::vector<LowerBound>& list) {
    for (const LowerBound& bound : list) {
      tried.push_back({{"metric", metric}, {"method", bound.method}, {"value_s", bound.value_s}});
    }
  };
  add("agi", bounds.agi_tried);
  add("wi", bounds.wi_tried);
  const nlohmann::ordered_json json{{"map", report.arguments.map},
                                    {"agents", options.agents},
                                    {"speed_mps", options.speed_mps},
                                    {"staying", report.arguments.staying},
                                    {"lower_bound_agi_s", bounds.agi_s},
                                    {"lower_bound_agi_method", bounds.agi_method},
                                    {"lower_bound_wi_s", bounds.wi_s},
                                    {"lower_bound_wi_method", bounds.wi_method},
                                    {"cyclic_wi_s", report.cyclic_wi_s},
                                    {"shortest_closed_walk_m", report.walk.length_m},
                                    {"shortest_closed_walk_source", report.walk.source},
                                    {"shortest_closed_walk_lower_m", report.walk_bound.length_m},
                                    {"shortest_closed_walk_lower_method", report.walk_bound.method},
                                    {"bounds", tried}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string Seconds(double value_s) { return FormatSeconds(value_s) + " s"; }
std::string Metres(double value_m) { return fmt::format("{:.2f} m", value_m); }

/// How far the lower value lies below the upper one.
std::string Gap(double lower, double upper) {
  return fmt::format("{:.2f} %", 100.0 * std::max(0.0, 1.0 - lower / upper));
}

std::string Draw(const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows) {
  std::string text;
  for (const StyledLine& line : TableLines(columns, rows)) {
    text += line.Draw(line.columns(), ViewStyle::kPlain) + "\n";
  }
  return text;
}

std::string AsText(const BoundsReport& report) {
  const EvaluationOptions& options = report.arguments.options;
  const LowerBounds& bounds = report.bounds;
  const double lower_m = report.walk_bound.length_m;
  std::string text =
      fmt::format("{}, {} robot{} at {:g} m/s; {}\n\n", report.arguments.map, options.agents,
                  options.agents == 1 ? "" : "s", options.speed_mps,
                  report.arguments.staying ? "they may stand still" : "they keep moving");
  text +=
      Draw({{""}, {"at least", Align::kRight}, {"at most", Align::kRight}, {"gap", Align::kRight}},
           {{{"average graph idleness"}, {Seconds(bounds.agi_s)}, {""}, {""}},
            {{"worst idleness"},
             {Seconds(bounds.wi_s)},
             {Seconds(report.cyclic_wi_s)},
             {Gap(bounds.wi_s, report.cyclic_wi_s)}},
            {{"shortest closed walk"},
             {Metres(lower_m)},
             {Metres(report.walk.length_m)},
             {Gap(lower_m, report.walk.length_m)}}});
  std::vector<TableRow> rows;
  const auto add = [&](const char* metric, const std::vector<LowerBound>& list,
                       const std::string& best) {
    for (const LowerBound& bound : list) {
      rows.push_back({{metric},
                      {bound.method},
                      {Seconds(bound.value_s)},
                      {bound.method == best ? "the best" : ""}});
    }
  };
  add("average graph idleness", bounds.agi_tried, bounds.agi_method);
  add("worst idleness", bounds.wi_tried, bounds.wi_method);
  rows.push_back({{"shortest closed walk"}, {report.walk_bound.method}, {Metres(lower_m)}, {""}});
  text += "\n" + Draw({{"at least"}, {"by"}, {"value", Align::kRight}, {""}}, rows);
  text += fmt::format("\nAt most: robots evenly spaced on the closed walk; the walk: {}.\n",
                      report.walk.source);
  return text;
}

void RunBounds(const BoundsArguments& arguments) {
  const EvaluationOptions options = ResolveOptions(arguments);
  const EvaluationMap map(arguments);
  std::optional<OutputFile> json;
  if (!arguments.json_path.empty()) json.emplace(arguments.json_path);
  const auto weights = map.graph().weights();
  const double lap_s = map.closed_walk().length_m / (options.agents * options.speed_mps);
  const BoundsReport report{
      .arguments = arguments,
      .bounds = BoundsOf(map, options, arguments.staying),
      .walk = map.closed_walk(),
      .walk_bound = ClosedWalkLowerBound(map.graph(), map.paths()),
      .cyclic_wi_s = *std::max_element(weights.begin(), weights.end()) * lap_s};
  if (json) {
    json->Write(AsJson(report));
    json->Commit();
  }
  fmt::print("{}", AsText(report));
}

}  // namespace

void AddBoundsCommand(CLI::App& app) {
  auto arguments = std::make_shared<BoundsArguments>();
  CLI::App* command =
      app.add_subcommand("bounds", "how low AGI and WI can be at best, for any team on one map");
  AddTeamArguments(*command, *arguments);
  command->add_flag("--stay", arguments->staying, "robots may stand still at vertices");
  command->footer("Example:\n  ronda bounds --map cumberland --agents 10");
  command->callback([arguments] { RunBounds(*arguments); });
}

}  // namespace ronda
