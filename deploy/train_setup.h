#pragma once
// From a command line and a run folder to the configuration that all processes of the run read.
//
// What a folder was begun with stays: another map, team or network is refused (InputError), a
// larger budget, another number of actors or other rates are taken. Errors name option or file,
// key, rule and value.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "actor/actor_config.h"
#include "common/run/config.h"
#include "common/run/run_config.h"
#include "common/world/closed_walk.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

/// As given on the command line; what is not given is not set.
struct TrainArguments {
  std::optional<std::string> map;
  std::optional<int> agents;
  std::optional<int> actors;
  std::optional<std::string> algorithm;
  std::optional<std::string> seconds;  // "90s"
  std::optional<std::int64_t> decisions;
  std::optional<std::string> run_folder;
  std::optional<std::int64_t> seed;
  std::optional<std::string> config_file;
  std::vector<std::string> settings;  // KEY=VALUE
};

/// When the launcher judges the policy while it trains.
struct EvaluationSchedule {
  int episodes = 10;         // of each evaluation
  double step = 1.0 / 30.0;  // share of the budget between two
};

EvaluationSchedule ReadEvaluationSchedule(Config& config);

/// Everything about a run that follows from its configuration. Not movable: `context` points into
/// it.
class TrainSetup {
 public:
  /// `stored` is the folder's config.toml, where it has one.
  TrainSetup(const TrainArguments& arguments, const std::optional<std::filesystem::path>& stored);
  TrainSetup(const TrainSetup&) = delete;
  TrainSetup& operator=(const TrainSetup&) = delete;

  const RunConfig& run() const { return run_; }
  const ActorConfig& actor() const { return actor_; }
  const EvaluationSchedule& evaluation() const { return evaluation_; }
  const Config& config() const { return config_; }
  const StrategyContext& context() const { return context_; }

 private:
  Config config_;
  RunConfig run_;
  ActorConfig actor_;
  EvaluationSchedule evaluation_;
  std::optional<PatrolGraph> graph_;
  std::optional<ShortestPaths> paths_;
  ClosedWalk walk_;
  StrategyContext context_;
};

}  // namespace ronda
