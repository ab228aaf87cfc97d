#pragma once
// A policy that nobody trained.
#include "common/environments/observation_encoder.h"
#include "common/policies/policy_file.h"
#include "tests/temporary_folder.h"
#include "tests/unit/evaluation_map.h"

namespace ronda::testing {

/// A policy of this observation with random weights, as it comes back from its file.
inline PolicyFile RandomPolicy(ObservationOptions options, const EvaluationMap& map, int robots) {
  options.robots = robots;
  const ObservationEncoder encoder(map.graph, map.paths, options);
  const int features = encoder.features_per_candidate();
  PolicyFile policy;
  policy.spec = {
      .kind = features > 0 ? NetworkSpec::Kind::kCandidateScorer : NetworkSpec::Kind::kMlp,
      .observation_size = encoder.observation_size(),
      .num_actions = encoder.num_actions(),
      .features = features,
      .hidden = {8},
      .schema = Schema(options)};
  policy.training.map = map.graph.name();
  policy.training.agents = robots;
  Rng rng(41);
  policy.weights.resize(ParameterCount(policy.spec));
  for (float& weight : policy.weights) weight = static_cast<float>(rng.Normal());
  const TemporaryFolder folder;
  WritePolicyFile(folder.path() / "policy", policy);
  return ReadPolicyFile(folder.path() / "policy");
}

}  // namespace ronda::testing
