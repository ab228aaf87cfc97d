#include "deploy/bounds_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "common/base/error.h"
#include "common/evaluation/output_file.h"
#include "common/evaluation/report_json.h"
#include "common/world/closed_walk_bound.h"
#include "deploy/evaluation_arguments.h"

namespace ronda {
namespace {

struct BoundsReport {
  std::string team;  // as FormatTeam
  LowerBounds bounds;
  ClosedWalk walk;
  ClosedWalkBound walk_bound;
};

void AddTo(nlohmann::ordered_json& json, const BoundsReport& report) {
  json["lower_bound_agi_s"] = report.bounds.agi_s;
  json["lower_bound_agi_method"] = report.bounds.agi_method;
  json["lower_bound_wi_s"] = report.bounds.wi_s;
  json["lower_bound_wi_method"] = report.bounds.wi_method;
  json["shortest_closed_walk_m"] = report.walk.length_m;
  json["shortest_closed_walk_source"] = report.walk.source;
  json["shortest_closed_walk_lower_m"] = report.walk_bound.length_m;
  json["shortest_closed_walk_lower_method"] = report.walk_bound.method;
}

std::string AsText(const BoundsReport& report) {
  const auto line = [](const char* what, const char* side, const std::string& value,
                       const std::string& method) {
    return fmt::format("  {:<24}{:<10}{:>12}   {}\n", what, side, value, method);
  };
  const auto metres = [](double value_m) { return fmt::format("{:.2f} m", value_m); };
  const LowerBounds& bounds = report.bounds;
  return report.team + "\n\n" +
         line("average graph idleness", "at least", FormatSeconds(bounds.agi_s) + " s",
              bounds.agi_method) +
         line("worst idleness", "at least", FormatSeconds(bounds.wi_s) + " s", bounds.wi_method) +
         line("shortest closed walk", "at least", metres(report.walk_bound.length_m),
              report.walk_bound.method) +
         line("", "at most", metres(report.walk.length_m), report.walk.source);
}

void RunBounds(const EvaluationArguments& arguments) {
  const EvaluationOptions options = ResolveOptions(arguments);
  const EvaluationMap map(arguments, options.conditions);
  std::optional<OutputFile> json;
  if (!arguments.json_path.empty()) json.emplace(arguments.json_path);
  const auto bounds = BoundsOf(map.context(), options);
  if (!bounds) throw UsageError("no bound is known where robots are repaired: leave --repair out");
  const BoundsReport report{.team = FormatTeam(arguments.map, options),
                            .bounds = *bounds,
                            .walk = *map.context().closed_walk,
                            .walk_bound = ClosedWalkLowerBound(map.graph(), *map.context().paths)};
  if (json) {
    auto value = TeamAsJsonValue(arguments.map, options);
    AddTo(value, report);
    json->Write(value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
    json->Commit();
  }
  fmt::print("{}", AsText(report));
}

}  // namespace

void AddBoundsCommand(CLI::App& app) {
  auto arguments = std::make_shared<EvaluationArguments>();
  CLI::App* command =
      app.add_subcommand("bounds", "how low AGI and WI can be at best, for any team on one map");
  AddTeamArguments(*command, *arguments);
  AddConditionArguments(*command, *arguments);
  command->footer("Example:\n  ronda bounds --map cumberland --agents 10");
  command->callback([arguments] { RunBounds(*arguments); });
}

}  // namespace ronda
