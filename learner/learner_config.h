#pragma once
// [dqn] and [learner] of the configuration, and the algorithm that they describe. Errors:
// InputError as run/config.h.
#include <chrono>
#include <memory>

#include "common/run/config.h"
#include "common/run/run_config.h"
#include "learner/algorithm.h"
#include "learner/dqn.h"

namespace ronda {

struct LearnerConfig {
  DqnConfig dqn;
  std::chrono::milliseconds publish_every{100};
  std::chrono::milliseconds checkpoint_every{5000};
  int outstanding = 8;           // mini-batches asked for ahead
  bool send_priorities = false;  // where the replay samples by them
};

LearnerConfig ReadLearnerConfig(Config& config, const RunConfig& run);

/// What `run.algorithm` names: dqn.
std::unique_ptr<Algorithm> MakeAlgorithm(const RunConfig& run, const LearnerConfig& config);

}  // namespace ronda
