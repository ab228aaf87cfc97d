#include "learner/learner_config.h"

#include "common/base/check.h"
#include "common/policies/network_config.h"

namespace ronda {

LearnerConfig ReadLearnerConfig(Config& config, const RunConfig& run) {
  LearnerConfig learner;
  DqnConfig& dqn = learner.dqn;
  dqn.network = NetworkOf(run);
  dqn.seed = run.seed;
  dqn.batch_size = run.batch_size;
  dqn.loss.double_q = config.GetBool("dqn.double", true, "Double DQN");
  dqn.loss.loss =
      config.GetString("dqn.loss", "huber", {"huber", "mse"}, "loss of the TD error") == "mse"
          ? LossKind::kSquared
          : LossKind::kHuber;
  dqn.loss.huber_delta =
      config.GetDouble("dqn.huber_delta", 2.0, 1e-6, 1e6, "where Huber turns linear");
  dqn.learning_rate_start =
      config.GetDouble("dqn.learning_rate_start", 1e-3, 0.0, 1.0, "Adam's, at progress 0");
  dqn.learning_rate_end =
      config.GetDouble("dqn.learning_rate_end", 1e-4, 0.0, 1.0, "Adam's, at progress 1");
  dqn.max_gradient_norm = config.GetDouble("dqn.max_gradient_norm", 10.0, 1e-6, 1e6,
                                           "larger gradients are scaled down");
  dqn.target_update = config.GetString("dqn.target_update", "hard", {"hard", "polyak"},
                                       "how the target network follows") == "polyak"
                          ? TargetUpdate::kPolyak
                          : TargetUpdate::kHard;
  dqn.target_interval = static_cast<std::uint64_t>(config.GetInt(
      "dqn.target_interval", 1000, 1, 1'000'000'000, "updates between copies (hard)"));
  dqn.polyak =
      config.GetDouble("dqn.polyak", 0.005, 1e-9, 1.0, "share taken over at each update (polyak)");
  CheckDqnConfig(dqn);
  const auto milliseconds = [&](const char* key, double fallback, const char* doc) {
    return std::chrono::milliseconds(
        static_cast<std::int64_t>(1000.0 * config.GetDouble(key, fallback, 0.001, 86'400.0, doc)));
  };
  learner.publish_every = milliseconds("learner.publish_every_s", 0.1, "between weights");
  learner.checkpoint_every = milliseconds("learner.checkpoint_every_s", 5.0, "between checkpoints");
  learner.outstanding = static_cast<int>(
      config.GetInt("learner.outstanding", 8, 1, 64, "mini-batches asked for ahead"));
  learner.send_priorities = run.prioritised;
  return learner;
}

std::unique_ptr<Algorithm> MakeAlgorithm(const RunConfig& run, const LearnerConfig& config) {
  RONDA_CHECK(run.algorithm == "dqn", "algorithm {}",
              run.algorithm);  // ReadRunConfig refuses others
  return std::make_unique<Dqn>(config.dqn);
}

}  // namespace ronda
