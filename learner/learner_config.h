#pragma once
// [dqn], [network] and [learner] of the configuration. Errors: InputError as run/config.h.
#include <chrono>

#include "common/run/config.h"
#include "common/run/run_config.h"
#include "learner/dqn.h"

namespace ronda {

struct LearnerConfig {
  DqnConfig dqn;
  std::chrono::milliseconds publish_every{100};
  std::chrono::milliseconds checkpoint_every{5000};
  int outstanding = 8;  // mini-batches asked for ahead
};

LearnerConfig ReadLearnerConfig(Config& config, const RunConfig& run);

/// The network that the run trains; its sizes follow from [interface].
NetworkSpec ReadNetworkSpec(Config& config, const RunConfig& run);

}  // namespace ronda
