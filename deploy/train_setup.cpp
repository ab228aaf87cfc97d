#include "deploy/train_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "common/base/error.h"
#include "common/run/duration.h"
#include "common/run/paths.h"
#include "common/world/graph_file.h"
#include "learner/learner_config.h"
#include "replay/replay_config.h"

namespace ronda {
namespace {

std::int64_t Cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void TakeArguments(Config& config, const TrainArguments& arguments, bool new_run) {
  for (const auto& setting : arguments.settings) config.Set(setting);
  if (arguments.map) {
    std::error_code error;
    const bool is_file = std::filesystem::is_regular_file(*arguments.map, error);
    config.Override("run.map",
                    is_file ? std::filesystem::absolute(*arguments.map).string() : *arguments.map,
                    "--map");
  }
  if (arguments.agents) config.Override("run.agents", std::int64_t{*arguments.agents}, "--agents");
  if (arguments.actors) config.Override("run.actors", std::int64_t{*arguments.actors}, "--actors");
  if (arguments.algorithm) config.Override("run.algorithm", *arguments.algorithm, "--algorithm");
  if (arguments.seed) config.Override("run.seed", *arguments.seed, "--seed");
  if (arguments.seconds) {
    config.Override("run.budget_s", ParseDuration(*arguments.seconds, "--for"), "--for");
  }
  if (arguments.decisions) {
    config.Override("run.budget_decisions", *arguments.decisions, "--decisions");
  }
  if (!new_run) return;
  if (!config.Has("run.actors")) config.Override("run.actors", Cores(), "by default");
  if (!config.Has("run.budget_s") && !config.Has("run.budget_decisions")) {
    config.Override("run.budget_s", 90.0, "by default");
  }
}

/// Refuses a change of what a run folder's policy and numbers rest on.
void CheckSameRun(const RunConfig& stored, const RunConfig& asked,
                  const std::filesystem::path& stored_file) {
  const auto check = [&](const char* key, const auto& before, const auto& now) {
    if (before != now) {
      throw InputError(fmt::format(
          "{}: this run was begun with {} = {}, which cannot change to {}; take another --run",
          stored_file.string(), key, before, now));
    }
  };
  check("run.map", stored.map, asked.map);
  check("run.length", stored.length, asked.length);
  check("run.agents", stored.agents, asked.agents);
  check("run.algorithm", stored.algorithm, asked.algorithm);
  check("interface.schema", stored.schema, asked.schema);
  check("network.hidden", fmt::format("{}", fmt::join(stored.hidden_sizes, ",")),
        fmt::format("{}", fmt::join(asked.hidden_sizes, ",")));
  check("network.layer_norm", stored.layer_norm, asked.layer_norm);
}

}  // namespace

EvaluationSchedule ReadEvaluationSchedule(Config& config) {
  EvaluationSchedule schedule;
  schedule.episodes =
      static_cast<int>(config.GetInt("evaluation.episodes", 10, 1, 1000,
                                     "of each evaluation during training, on seeds of its own"));
  schedule.step = config.GetDouble("evaluation.step", 1.0 / 30.0, 1e-4, 1.0,
                                   "share of the budget between two evaluations");
  return schedule;
}

TrainSetup::TrainSetup(const TrainArguments& arguments,
                       const std::optional<std::filesystem::path>& stored) {
  if (stored && arguments.config_file) {
    throw UsageError(fmt::format("--config: the run folder has its own {}; change keys with --set",
                                 stored->string()));
  }
  if (stored) config_ = Config::FromFile(*stored);
  if (arguments.config_file) config_ = Config::FromFile(*arguments.config_file);
  TakeArguments(config_, arguments, !stored);

  run_ = ReadRunConfig(config_);
  actor_ = ReadActorConfig(config_, run_);
  std::vector<std::string> warnings;
  graph_.emplace(
      WithPriorities(LoadMap(run_.map, MapsFolder(), ParseEdgeLengthSource(run_.length), &warnings),
                     actor_.environment.conditions));
  for (const auto& warning : warnings) fmt::print(stderr, "ronda: warning: {}\n", warning);
  paths_.emplace(*graph_);
  walk_ = ClosedWalkOf(*graph_, *paths_);
  context_ = {.graph = &*graph_, .paths = &*paths_, .closed_walk = &walk_};
  const ObservationEncoder encoder(*graph_, *paths_, ObservationOf(actor_.environment));
  const auto follows = [&](const char* key, Config::Value value) {
    config_.Override(key, std::move(value), "follows from the map");
  };
  follows("interface.observation_size", std::int64_t{encoder.observation_size()});
  follows("interface.num_actions", std::int64_t{encoder.num_actions()});
  follows("interface.features", std::int64_t{encoder.features_per_candidate()});
  follows("interface.schema", Schema(encoder.options()));
  const PatrolEnvironmentOptions& environment = actor_.environment;
  const Conditions& conditions = environment.conditions;
  const double t_ref_s = walk_.length_m / TotalSpeed_mps(conditions, environment.agents);
  const bool alike = conditions.speeds_mps.size() == 1;
  follows("interface.speed_mps", alike ? conditions.speeds_mps.front() : 0.0);
  follows("interface.reward", std::string(Name(environment.reward)));
  follows("interface.discount_horizon_s", environment.horizon * t_ref_s);
  run_ = ReadRunConfig(config_);
  ReadLearnerConfig(config_, run_);
  ReadReplayConfig(config_, run_);
  evaluation_ = ReadEvaluationSchedule(config_);
  config_.RejectUnknown();
  if (stored) {
    Config before = Config::FromFile(*stored);
    CheckSameRun(ReadRunConfig(before), run_, *stored);
  }
}

}  // namespace ronda
