#include "actor/actor_config.h"

#include "actor/conditions_config.h"

namespace ronda {

ActorConfig ReadActorConfig(Config& config, const RunConfig& run) {
  ActorConfig actor;
  PatrolEnvironmentOptions& environment = actor.environment;
  environment.agents = run.agents;
  environment.conditions = ReadConditions(config, run.agents);
  environment.horizon = config.GetDouble("environment.horizon_t_ref", 0.3, 1e-3, 1e3,
                                         "discount horizon −1/ln γ, in T_ref");
  environment.episode_length = config.GetDouble("environment.episode_t_ref", 40.0, 0.1, 1e6,
                                                "length of an episode, in T_ref");
  environment.observation.scheme = ParseObservationScheme(
      config.GetString("observation", "candidates", ObservationNames(), "what a robot sees"));
  environment.observation.alpha =
      config.GetDouble("observation_alpha", 0.0, 0.0, 1e12,
                       "α > 1 of f(x) = (α^x − 1)/(α − 1), which ranking and normalised idleness "
                       "may pass through; 0: off");
  environment.reward = ParseRewardScheme(config.GetString("reward", "hindsight", RewardNames(),
                                                          "what a visit is worth",
                                                          "`common/environments/reward.h`"));
  environment.reward_n_worst = static_cast<int>(
      config.GetInt("reward_n_worst", 3, 1, PatrolGraph::kMaxVertices,
                    "the reward n-worst is given at so many of the most idle vertices"));
  environment.initial_idleness = config.GetDouble("environment.initial_idleness", 0.0, 0.0, 1e3,
                                                  "vertices start idle for up to so many T_ref");
  ExplorationOptions& exploration = actor.exploration;
  exploration.decay = ParseExplorationDecay(config.GetString(
      "exploration.schedule", "linear", {"linear", "exponential"}, "how ε falls with progress"));
  exploration.start = config.GetDouble("exploration.start", 1.0, 0.0, 1.0, "ε at the beginning");
  exploration.end = config.GetDouble("exploration.end", 0.05, 0.0, 1.0, "ε at last");
  exploration.share = config.GetDouble("exploration.share", 0.3, 1e-9, 1.0,
                                       "share of the budget until ε is at its last value");
  exploration.ladder = config.GetDouble("exploration.ladder", 0.0, 0.0, 100.0,
                                        "spread α of ε among actors; 0: all alike");
  CheckExploration(exploration);
  actor.n_steps = static_cast<int>(
      config.GetInt("actor.n_steps", 1, 1, 100, "decisions that a transition spans"));
  actor.batch_size = static_cast<std::uint32_t>(
      config.GetInt("actor.batch_size", 256, 1, 256, "transitions in a message"));
  actor.max_age = std::chrono::milliseconds(config.GetInt(
      "actor.max_age_ms", 10, 1, 10'000, "oldest transition of a message that is not full"));
  return actor;
}

}  // namespace ronda
