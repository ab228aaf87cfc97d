#include "common/team/policy_strategy.h"

#include <catch2/catch.hpp>
#include <string>

#include "common/base/error.h"
#include "common/environments/observation_encoder.h"
#include "common/evaluation/protocol.h"
#include "tests/temporary_folder.h"
#include "tests/unit/evaluation_map.h"

namespace ronda {
namespace {

constexpr int kRobots = 2;

/// A policy of this observation with random weights, as it comes back from its file.
PolicyFile PolicyWith(ObservationOptions options, const testing::EvaluationMap& map) {
  options.robots = kRobots;
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
  policy.training.agents = kRobots;
  Rng rng(41);
  policy.weights.resize(ParameterCount(policy.spec));
  for (float& weight : policy.weights) weight = static_cast<float>(rng.Normal());
  const TemporaryFolder folder;
  WritePolicyFile(folder.path() / "policy", policy);
  return ReadPolicyFile(folder.path() / "policy");
}

double Agi(const PolicyFile& policy, const testing::EvaluationMap& map, int robots) {
  const auto result = Evaluate(
      map.context(), [&] { return MakePolicyStrategy(policy, map.context()); },
      {.episodes = 3, .agents = robots}, nullptr);
  return MeanWithInterval(result->agi_s()).mean;
}

TEST_CASE("A policy of every observation plays the map and the team that it was trained on") {
  const testing::EvaluationMap map("4nodes");
  for (const std::string& name : ObservationNames()) {
    INFO(name);
    CHECK(Agi(PolicyWith(ParseObservationScheme(name), map), map, kRobots) > 0.0);
  }
}

TEST_CASE("A policy is evaluated with the α that it was trained with") {
  const testing::EvaluationMap map("grid");
  const ObservationOptions bent{ObservationScheme::kNormalised, 1e5};
  PolicyFile policy = PolicyWith(bent, map);
  CHECK(SchemeOf(policy.spec.schema).alpha == 1e5);
  const double with_alpha = Agi(policy, map, kRobots);

  policy.spec.schema = Schema(ObservationScheme::kNormalised);  // the same weights without it

  CHECK(Agi(policy, map, kRobots) != with_alpha);
}

TEST_CASE("A policy that observes the matrix refuses another team, and the others take it") {
  const testing::EvaluationMap map("4nodes");
  const PolicyFile matrix = PolicyWith(ObservationScheme::kMatrix, map);
  CHECK_THROWS_AS(Agi(matrix, map, 3), InputError);
  CHECK_THROWS_WITH(Agi(matrix, map, 3), "the policy observes a team of 2 robots, this one has 3");
  CHECK(Agi(PolicyWith(ObservationScheme::kSorted, map), map, 3) > 0.0);
}

}  // namespace
}  // namespace ronda
