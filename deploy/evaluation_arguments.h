#pragma once
// What `ronda evaluate` and `ronda compare` share: their options, the map with what follows from
// it, and the evaluation of one contestant.
//
// Errors: UsageError for options out of range, InputError for maps and policies. Warnings of the
// map reader go to stderr.
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
  std::string json_path;            // empty: none
  std::optional<double> horizon_s;  // only where given
  EvaluationOptions options;        // protocol and horizon are set by ResolveOptions
};

/// Adds a subcommand's options of one setting: map, team and conditions. `arguments` must live as
/// long as it.
void AddSettingArguments(CLI::App& command, EvaluationArguments& arguments);
/// Adds those of all settings: protocol, episodes, seed, speed, lengths, JSON.
void AddProtocolArguments(CLI::App& command, EvaluationArguments& arguments);

/// The options that the arguments stand for, checked.
EvaluationOptions ResolveOptions(const EvaluationArguments& arguments);

/// A map and what follows from it, made once. Not movable: its context points into it.
class EvaluationMap {
 public:
  /// `map` as the user named it, `length` as the option.
  EvaluationMap(const std::string& map, const std::string& length);
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
