#include "deploy/compare_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "common/base/error.h"
#include "common/evaluation/comparison.h"
#include "deploy/evaluation_arguments.h"

namespace ronda {
namespace {

struct CompareArguments : EvaluationArguments {
  std::vector<std::string> policies;
  std::vector<std::string> strategies;
};

std::vector<Contestant> Contestants(const CompareArguments& arguments) {
  std::vector<Contestant> contestants;
  for (const std::string& name : arguments.policies) {
    contestants.push_back({.kind = ContestantKind::kPolicy, .name = name});
  }
  for (const std::string& name : arguments.strategies) {
    const auto names = name == "all" ? AllStrategyNames() : std::vector<std::string>{name};
    for (const std::string& each : names) {
      contestants.push_back({.kind = ContestantKind::kStrategy, .name = each});
    }
  }
  if (contestants.empty()) throw UsageError("nothing to compare: give --policy or --strategies");
  return contestants;
}

/// Thesis protocol: every report's ratio to the random walk, which is played if nobody else did.
bool AddRatiosToRandom(std::vector<EvaluationReport>& reports, const EvaluationMap& map,
                       const EvaluationOptions& options, const std::stop_token& stop) {
  if (options.protocol != Protocol::kThesis) return true;
  const auto random = EvaluateContestant({.name = "random"}, map.context(), options, nullptr, stop);
  if (!random) return false;
  for (EvaluationReport& report : reports) {
    report.ratio_to_random = RatioToRandom(*random, report.result);
  }
  return true;
}

void RunCompare(const CompareArguments& arguments, const std::stop_token& stop) {
  const EvaluationOptions options = ResolveOptions(arguments);
  const std::vector<Contestant> contestants = Contestants(arguments);
  const EvaluationMap map(arguments, options.conditions);
  for (const Contestant& contestant : contestants) MakeContestant(contestant, map.context());
  std::optional<OutputFile> json;
  if (!arguments.json_path.empty()) json.emplace(arguments.json_path);
  const auto bounds = BoundsOf(map.context(), options);
  std::vector<EvaluationReport> reports;
  for (const Contestant& contestant : contestants) {
    auto result = EvaluateContestant(contestant, map.context(), options, nullptr, stop);
    if (!result) return;
    reports.push_back({.map = arguments.map,
                       .contestant = contestant,
                       .options = options,
                       .result = *std::move(result),
                       .bounds = bounds,
                       .ratio_to_random = std::nullopt});
  }
  if (!AddRatiosToRandom(reports, map, options, stop)) return;
  if (json) {
    json->Write(ComparisonAsJson(reports) + "\n");
    json->Commit();
  }
  fmt::print("{}", FormatComparison(reports));
}

}  // namespace

void AddCompareCommand(CLI::App& app, std::stop_token stop) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "policies and strategies on one map, in one table");
  AddEvaluationArguments(*command, *arguments);
  command
      ->add_option("--policy", arguments->policies,
                   "a run folder, a policy file or a shipped policy's name; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--strategies", arguments->strategies,
                   "all, or a comma-separated list of " + StrategyNames())
      ->delimiter(',')
      ->allow_extra_args(false);
  command->footer("Example:\n  ronda compare --map cumberland --agents 10 --strategies all");
  command->callback([arguments, stop] { RunCompare(*arguments, stop); });
}

}  // namespace ronda
