#pragma once
// The network that a run trains, from its configuration: actors and the learner must build the same
// one.
#include "common/nn/network_spec.h"
#include "common/policies/policy_file.h"
#include "common/run/run_config.h"

namespace ronda {

/// A scorer where the observation is made of candidates, else a perceptron over the whole
/// observation.
NetworkSpec NetworkOf(const RunConfig& run);

/// What the run's policy files say of it: all but weights, version, updates and how long it was
/// trained.
PolicyFile PolicyOf(const RunConfig& run);

}  // namespace ronda
