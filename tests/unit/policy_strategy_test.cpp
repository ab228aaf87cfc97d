#include "common/team/policy_strategy.h"

#include <catch2/catch.hpp>
#include <string>

#include "common/base/error.h"
#include "common/environments/observation_encoder.h"
#include "common/evaluation/protocol.h"
#include "tests/unit/random_policy.h"

namespace ronda {
namespace {

using testing::RandomPolicy;

constexpr int kRobots = 2;

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
    CHECK(Agi(RandomPolicy(ParseObservationScheme(name), map, kRobots), map, kRobots) > 0.0);
  }
}

TEST_CASE("A policy is evaluated with the α that it was trained with") {
  const testing::EvaluationMap map("grid");
  const ObservationOptions bent{ObservationScheme::kNormalised, 1e5};
  PolicyFile policy = RandomPolicy(bent, map, kRobots);
  CHECK(SchemeOf(policy.spec.schema).alpha == 1e5);
  const double with_alpha = Agi(policy, map, kRobots);

  policy.spec.schema = Schema(ObservationScheme::kNormalised);  // the same weights without it

  CHECK(Agi(policy, map, kRobots) != with_alpha);
}

TEST_CASE("A policy that observes the matrix refuses another team, and the others take it") {
  const testing::EvaluationMap map("4nodes");
  const PolicyFile matrix = RandomPolicy(ObservationScheme::kMatrix, map, kRobots);
  CHECK_THROWS_AS(Agi(matrix, map, 3), InputError);
  CHECK_THROWS_WITH(Agi(matrix, map, 3), "the policy observes a team of 2 robots, this one has 3");
  CHECK(Agi(RandomPolicy(ObservationScheme::kSorted, map, kRobots), map, 3) > 0.0);
}

}  // namespace
}  // namespace ronda
