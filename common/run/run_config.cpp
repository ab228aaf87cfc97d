#include "common/run/run_config.h"

#include <limits>

namespace ronda {

RunConfig ReadRunConfig(Config& config) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  constexpr std::int64_t kMany = 1'000'000'000'000;
  RunConfig run;
  run.map = config.GetString("run.map", "cumberland", {}, "a map that ships, or a file");
  run.length = config.GetString("run.length", "euclidean", {"euclidean", "file"},
                                "where edge lengths come from");
  run.agents = static_cast<int>(config.GetInt("run.agents", 10, 1, 10'000, "robots on the map"));
  run.actors = static_cast<int>(config.GetInt("run.actors", 1, 1, kMaxActors, "actor processes"));
  run.algorithm = config.GetString("run.algorithm", "dqn", {"dqn"}, "what the learner runs");
  run.seed = static_cast<std::uint64_t>(
      config.GetInt("run.seed", 1, 0, kMany, "all random choices follow from it"));
  run.budget_s =
      config.GetDouble("run.budget_s", 0.0, 0.0, kNoLimit,
                       "seconds of training in all, from the first transition; 0: no limit");
  run.budget_decisions = static_cast<std::uint64_t>(
      config.GetInt("run.budget_decisions", 0, 0, kMany, "decisions in all; 0: no limit"));
  run.shape.observation_size =
      static_cast<std::uint32_t>(config.GetInt("interface.observation_size", 0, 0, 262'144,
                                               "floats of an observation (follows from the map)"));
  run.shape.num_actions = static_cast<std::uint32_t>(
      config.GetInt("interface.num_actions", 0, 0, 100'000, "actions (follows from the map)"));
  run.features = static_cast<int>(
      config.GetInt("interface.features", 0, 0, 10'000, "features of one candidate; 0: none"));
  run.schema = config.GetString("interface.schema", "", {}, "name of the observation");
  run.speed_mps = config.GetDouble("interface.speed_mps", 0.0, 0.0, kNoLimit,
                                   "of every robot (the environment's); 0: they differ");
  run.reward = config.GetString("interface.reward", "", {}, "name of the reward");
  run.discount_horizon_s = config.GetDouble("interface.discount_horizon_s", 0.0, 0.0, kNoLimit,
                                            "−1/ln γ (follows from map and team)");
  run.hidden_sizes =
      config.GetIntList("network.hidden", {64, 64}, 1, 4096, "widths of the hidden layers");
  run.layer_norm = config.GetBool("network.layer_norm", false, "LayerNorm before each activation");
  run.prioritised = config.GetString("replay.sampler", "uniform", {"uniform", "prioritised"},
                                     "how mini-batches are drawn") == "prioritised";
  run.batch_size = static_cast<std::uint32_t>(
      config.GetInt("dqn.batch_size", 128, 1, 1024, "transitions in a mini-batch"));
  run.socket_buffer_bytes =
      static_cast<int>(config.GetInt("dds.socket_buffer_bytes", 4 << 20, 65'536, 1 << 30,
                                     "asked of the kernel, which may give less; bytes"));
  return run;
}

}  // namespace ronda
