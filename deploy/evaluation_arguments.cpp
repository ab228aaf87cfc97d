#include "deploy/evaluation_arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "common/base/error.h"
#include "common/team/policy_strategy.h"
#include "common/world/conditions_text.h"
#include "deploy/find_policy.h"
#include "deploy/named_map.h"
#include "deploy/seed_rule.h"

namespace ronda {

void AddTeamArguments(CLI::App& command, EvaluationArguments& arguments) {
  command.add_option("--map", arguments.map, kMapHelp)->required();
  command.add_option("--agents", arguments.options.agents, "number of robots, 1 … 10000")
      ->required();
}

void AddConditionArguments(CLI::App& command, EvaluationArguments& arguments) {
  for (const ConditionOption& condition : ConditionOptions()) {
    command.add_option(fmt::format("--{}", condition.name), arguments.conditions[condition.name],
                       condition.doc);
  }
  AddLengthOption(command, arguments.length);
  command.add_option("--json", arguments.json_path, "write the result to this file");
}

void AddEvaluationArguments(CLI::App& command, EvaluationArguments& arguments) {
  EvaluationOptions& options = arguments.options;
  AddConditionArguments(command, arguments);
  // CLI11 reads "-1" into an unsigned number without complaint.
  command.add_option("--protocol", arguments.protocol, "steady or thesis")
      ->check(CLI::IsMember({"steady", "thesis"}))
      ->capture_default_str();
  command.add_option("--horizon", arguments.horizon_s,
                     "thesis protocol: seconds from zero idleness to the end (default 600)");
  command.add_option("--episodes", options.episodes, "how many episodes, 1 … 1000000")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "starts, noise and decisions follow from it")
      ->check(SeedRule())
      ->capture_default_str();
}

EvaluationOptions ResolveOptions(const EvaluationArguments& arguments) {
  EvaluationOptions options = arguments.options;
  if (arguments.protocol == "thesis") options.protocol = Protocol::kThesis;
  if (arguments.horizon_s && options.protocol != Protocol::kThesis) {
    throw UsageError("--horizon needs --protocol thesis: the steady window follows from the map");
  }
  options.horizon_s = arguments.horizon_s.value_or(options.horizon_s);
  for (const auto& [name, text] : arguments.conditions) {
    if (!text.empty()) SetCondition(options.conditions, name, text);
  }
  CheckOptions(options);
  return options;
}

EvaluationMap::EvaluationMap(const EvaluationArguments& arguments, const Conditions& conditions)
    : graph_(WithPriorities(LoadNamedMap(arguments.map, arguments.length), conditions)),
      paths_(graph_),
      walk_(ClosedWalkOf(graph_, paths_)) {}

std::unique_ptr<Strategy> MakeContestant(const Contestant& contestant,
                                         const StrategyContext& context) {
  return contestant.kind == ContestantKind::kPolicy
             ? LoadPolicyStrategy(FindPolicyFile(contestant.name), context)
             : MakeStrategy(contestant.name, context);
}

std::optional<EvaluationResult> EvaluateContestant(const Contestant& contestant,
                                                   const StrategyContext& context,
                                                   const EvaluationOptions& options,
                                                   TraceWriter* trace, std::stop_token stop) {
  return Evaluate(
      context, [&] { return MakeContestant(contestant, context); }, options, trace,
      std::move(stop));
}

double RatioToRandom(const EvaluationResult& random, const EvaluationResult& result) {
  return MeanWithInterval(random.final_s()).mean / MeanWithInterval(result.final_s()).mean;
}

}  // namespace ronda
