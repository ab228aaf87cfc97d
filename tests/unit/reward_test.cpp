#include "common/environments/reward.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "common/base/error.h"

namespace ronda {
namespace {

constexpr RewardParameters kParameters{.horizon_s = 30.0, .reference_s = 60.0, .n_worst = 2};

/// Idleness of 5 vertices; mean 20 s. 1 and 3 are equally idle.
const std::vector<double> kIdleness_s = {0.0, 10.0, 50.0, 10.0, 30.0};

/// The values of a visit of each vertex.
std::vector<double> Values(RewardScheme scheme, const std::vector<double>& idleness_s,
                           const RewardParameters& parameters = kParameters,
                           bool last_step = false) {
  std::vector<double> values;
  for (std::size_t v = 0; v < idleness_s.size(); ++v) {
    const Visit visit{
        .vertex = static_cast<int>(v), .idleness_s = idleness_s, .last_step = last_step};
    values.push_back(RewardValue(scheme, visit, parameters));
  }
  return values;
}

using Numbers = std::vector<double>;

TEST_CASE("The idleness reward is the visited vertex's idleness") {
  CHECK(Values(RewardScheme::kIdleness, kIdleness_s) == kIdleness_s);
}

TEST_CASE("The ranking reward is the rank from 1 to V, of equals the lower index the lower rank") {
  CHECK(Values(RewardScheme::kRanking, kIdleness_s) == Numbers{1, 2, 5, 3, 4});
  CHECK(Values(RewardScheme::kRanking, {7.0, 7.0, 7.0}) == Numbers{1, 2, 3});
}

TEST_CASE("The normalised reward runs from 0 to 1, and is 0 where all are equally idle") {
  CHECK(Values(RewardScheme::kNormalised, kIdleness_s) == Numbers{0.0, 0.2, 1.0, 0.2, 0.6});
  CHECK(Values(RewardScheme::kNormalised, {10.0, 20.0, 30.0}) == Numbers{0.0, 0.5, 1.0});
  CHECK(Values(RewardScheme::kNormalised, {7.0, 7.0, 7.0}) == Numbers{0.0, 0.0, 0.0});
}

TEST_CASE("The centred reward is the idleness less the mean") {
  CHECK(Values(RewardScheme::kCentred, kIdleness_s) == Numbers{-20.0, -10.0, 30.0, -10.0, 10.0});
  CHECK(Values(RewardScheme::kCentred, {7.0, 7.0, 7.0}) == Numbers{0.0, 0.0, 0.0});
}

TEST_CASE("The average reward is less the mean idleness, wherever the visit is") {
  CHECK(Values(RewardScheme::kAverage, kIdleness_s) == Numbers(5, -20.0));
}

TEST_CASE("The n-worst reward is 1 where fewer than n vertices are more idle") {
  const auto n_worst = [](int n, const std::vector<double>& idleness_s) {
    return Values(RewardScheme::kNWorst, idleness_s, {.n_worst = n});
  };
  CHECK(n_worst(1, kIdleness_s) == Numbers{0, 0, 1, 0, 0});
  CHECK(n_worst(2, kIdleness_s) == Numbers{0, 0, 1, 0, 1});
  CHECK(n_worst(3, kIdleness_s) == Numbers{0, 1, 1, 1, 1});  // both that tie for the third place
  CHECK(n_worst(4, kIdleness_s) == Numbers{0, 1, 1, 1, 1});
  CHECK(n_worst(9, kIdleness_s) == Numbers{1, 1, 1, 1, 1});
  CHECK(n_worst(1, {7.0, 7.0, 7.0}) == Numbers{1, 1, 1});
}

TEST_CASE("The final-average reward is less the mean idleness at the last step, and 0 before") {
  CHECK(Values(RewardScheme::kFinalAverage, kIdleness_s) == Numbers(5, 0.0));
  CHECK(Values(RewardScheme::kFinalAverage, kIdleness_s, kParameters, true) == Numbers(5, -20.0));
}

TEST_CASE("The hindsight reward keeps of the idleness what nobody would have collected by then") {
  const double forever = std::numeric_limits<double>::infinity();
  CHECK(Values(RewardScheme::kHindsight, kIdleness_s) == kIdleness_s);
  CHECK(HindsightReward(0.5f, 60.0, kParameters) == Approx(0.5 * (1.0 - std::exp(-2.0))));
  CHECK(HindsightReward(0.5f, forever, kParameters) == 0.5f);
  CHECK(HindsightReward(0.5f, 0.0, kParameters) == 0.0f);
}

TEST_CASE("Rewards are discounted to the decision; times are scaled by 2/T_ref, ranks by 1/V") {
  const auto reward = [](RewardScheme scheme) {
    return Reward(scheme,
                  {.travel_s = 15.0, .vertex = 4, .idleness_s = kIdleness_s, .last_step = true},
                  kParameters);
  };
  const double discount = std::exp(-0.5);
  CHECK(reward(RewardScheme::kIdleness) == Approx(discount * 30.0 / 30.0));
  CHECK(reward(RewardScheme::kRanking) == Approx(discount * 4.0 / 5.0));
  CHECK(reward(RewardScheme::kNormalised) == Approx(discount * 0.6));
  CHECK(reward(RewardScheme::kCentred) == Approx(discount * 10.0 / 30.0));
  CHECK(reward(RewardScheme::kAverage) == Approx(discount * -20.0 / 30.0));
  CHECK(reward(RewardScheme::kNWorst) == Approx(discount));
  CHECK(reward(RewardScheme::kFinalAverage) == Approx(discount * -20.0 / 30.0));
  CHECK(reward(RewardScheme::kHindsight) == Approx(discount * 30.0 / 30.0));
}

TEST_CASE("A discount is γ^τ, and never 0 however long an edge takes") {
  CHECK(Discount(15.0, 30.0) == Approx(std::exp(-0.5)));
  CHECK(Discount(0.0, 30.0) == 1.0f);
  CHECK(Discount(1e6, 1.0) > 0.0f);
}

TEST_CASE("Rewards are chosen by name, and an unknown name is answered with the known ones") {
  for (const std::string& name : RewardNames()) CHECK(Name(ParseRewardScheme(name)) == name);
  CHECK_THROWS_AS(ParseRewardScheme("fame"), UsageError);
  CHECK_THROWS_WITH(
      ParseRewardScheme("fame"),
      Catch::StartsWith("the reward must be one of idleness, ranking, normalised, centred, "
                        "average, n-worst, final-average, hindsight") &&
          Catch::EndsWith(", got 'fame'"));
}

}  // namespace
}  // namespace ronda
