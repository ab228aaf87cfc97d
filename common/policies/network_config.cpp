#include "common/policies/network_config.h"

#include <fmt/format.h>

namespace ronda {

NetworkSpec NetworkOf(const RunConfig& run) {
  NetworkSpec spec;
  spec.kind = run.features > 0 ? NetworkSpec::Kind::kCandidateScorer : NetworkSpec::Kind::kMlp;
  spec.observation_size = static_cast<int>(run.shape.observation_size);
  spec.num_actions = static_cast<int>(run.shape.num_actions);
  spec.features = run.features;
  spec.hidden = run.hidden_sizes;
  spec.layer_norm = run.layer_norm;
  spec.schema = run.schema;
  return spec;
}

PolicyFile PolicyOf(const RunConfig& run) {
  PolicyFile policy;
  policy.spec = NetworkOf(run);
  policy.map = run.map;
  policy.agents = run.agents;
  policy.training = fmt::format("{}, seed {}", run.algorithm, run.seed);
  return policy;
}

}  // namespace ronda
