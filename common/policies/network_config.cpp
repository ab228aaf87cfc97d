#include "common/policies/network_config.h"

#include <filesystem>

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
  policy.training = {.map = std::filesystem::path(run.map).stem().string(),
                     .agents = run.agents,
                     .speed_mps = run.speed_mps,
                     .algorithm = run.algorithm,
                     .seed = static_cast<std::int64_t>(run.seed),
                     .reward = run.reward,
                     .discount_horizon_s = run.discount_horizon_s,
                     .ronda_version = RONDA_VERSION};
  return policy;
}

}  // namespace ronda
