#pragma once
// What `ronda evaluate` and `ronda compare` share: their options, the map with what follows from
// it, and the evaluation of one contestant.
//
// Errors: UsageError for options out of range, InputError for maps and policies. Warnings of the
// map reader go to stderr.
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "common/evaluation/report.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"

namespace CLI {
class App;
}

namespace ronda {

struct EvaluationArguments {
  std::string map;
  std::string protocol = "steady";
  std::string length = "euclidean";
  std::string json_path;                          // empty: none
  std::optional<double> horizon_s;                // only where given
  std::map<std::string, std::string> conditions;  // text by ConditionOption::name; empty: none
  EvaluationOptions options;  // protocol, horizon and conditions are set by ResolveOptions
};

/// Each adds some options to a subcommand; `arguments` must live as long as it. One map and one
/// number of robots:
void AddTeamArguments(CLI::App& command, EvaluationArguments& arguments);

/// Conditions, lengths and the JSON file:
void AddConditionArguments(CLI::App& command, EvaluationArguments& arguments);

/// Those of AddConditionArguments, and the protocol:
void AddEvaluationArguments(CLI::App& command, EvaluationArguments& arguments);

/// The options that the arguments stand for, checked.
EvaluationOptions ResolveOptions(const EvaluationArguments& arguments);

/// A map and what follows from it, made once. Not movable: its context points into it.
class EvaluationMap {
 public:
  /// With the conditions' priorities.
  EvaluationMap(const EvaluationArguments& arguments, const Conditions& conditions);
  EvaluationMap(const EvaluationMap&) = delete;
  EvaluationMap& operator=(const EvaluationMap&) = delete;

  const PatrolGraph& graph() const { return graph_; }
  StrategyContext context() const {
    return {.graph = &graph_, .paths = &paths_, .closed_walk = &walk_};
  }

 private:
  PatrolGraph graph_;
  ShortestPaths paths_;
  ClosedWalk walk_;
};

/// Makes the contestant's strategy; throws where there is none of that name.
std::unique_ptr<Strategy> MakeContestant(const Contestant& contestant,
                                         const StrategyContext& context);

/// nullopt when stopped. `trace` may be null.
std::optional<EvaluationResult> EvaluateContestant(const Contestant& contestant,
                                                   const StrategyContext& context,
                                                   const EvaluationOptions& options,
                                                   TraceWriter* trace, std::stop_token stop);

/// The random walk's mean final idleness over that of `result`.
double RatioToRandom(const EvaluationResult& random, const EvaluationResult& result);

}  // namespace ronda
