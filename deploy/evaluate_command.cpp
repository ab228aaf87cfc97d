#include "deploy/evaluate_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "common/base/error.h"
#include "deploy/evaluation_arguments.h"

namespace ronda {
namespace {

struct EvaluateArguments : EvaluationArguments {
  std::string policy;
  std::string strategy;
  std::string trace_path;
};

void RunEvaluate(const EvaluateArguments& arguments, const std::stop_token& stop) {
  const EvaluationOptions options = ResolveOptions(arguments);
  const EvaluationMap map(arguments, options.conditions);
  const Contestant contestant =
      arguments.policy.empty()
          ? Contestant{.kind = ContestantKind::kStrategy, .name = arguments.strategy}
          : Contestant{.kind = ContestantKind::kPolicy, .name = arguments.policy};
  MakeContestant(contestant, map.context());  // a bad name shows before any file is touched
  if (!arguments.json_path.empty() && arguments.json_path == arguments.trace_path) {
    throw UsageError(fmt::format("--json and --trace both name {}", arguments.json_path));
  }
  std::optional<OutputFile> json;
  std::optional<TraceWriter> trace;
  if (!arguments.json_path.empty()) json.emplace(arguments.json_path);
  if (!arguments.trace_path.empty()) {
    trace.emplace(arguments.trace_path, map.graph(), arguments.map);
  }
  auto result =
      EvaluateContestant(contestant, map.context(), options, trace ? &*trace : nullptr, stop);
  if (!result) return;
  EvaluationReport report{.map = arguments.map,
                          .contestant = contestant,
                          .options = options,
                          .result = *std::move(result),
                          .bounds = BoundsOf(map.context(), options),
                          .ratio_to_random = std::nullopt};
  if (options.protocol == Protocol::kThesis) {
    const auto random =
        EvaluateContestant({.name = "random"}, map.context(), options, nullptr, stop);
    if (!random) return;
    report.ratio_to_random = RatioToRandom(*random, report.result);
  }
  if (trace) trace->Commit();
  if (json) {
    json->Write(ReportAsJson(report) + "\n");
    json->Commit();
  }
  fmt::print("{}", FormatReport(report));
}

}  // namespace

void AddEvaluateCommand(CLI::App& app, std::stop_token stop) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "judge one policy or strategy on one map");
  AddTeamArguments(*command, *arguments);
  AddEvaluationArguments(*command, *arguments);
  auto* contestant = command->add_option_group("contestant");
  contestant->add_option("--policy", arguments->policy,
                         "a run folder, a policy file or a shipped policy's name");
  contestant->add_option("--strategy", arguments->strategy, StrategyNames());
  contestant->require_option(1);
  command->add_option("--trace", arguments->trace_path, "write every visit to this CSV file");
  command->footer("Example:\n  ronda evaluate --map cumberland --agents 10 --strategy sebs");
  command->callback([arguments, stop] { RunEvaluate(*arguments, stop); });
}

}  // namespace ronda
