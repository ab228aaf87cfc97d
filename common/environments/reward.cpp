#include "common/environments/reward.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/base/error.h"

namespace ronda {
namespace {

using Parameters = RewardParameters;

double Idleness(const Visit& visit, const Parameters&) { return visit.idleness_s[visit.vertex]; }

double Ranking(const Visit& visit, const Parameters&) {
  const auto before = visit.idleness_s.first(static_cast<std::size_t>(visit.vertex));
  const auto others = visit.idleness_s.subspan(before.size());
  const double own_s = others.front();
  const auto at_most = [=](double idleness_s) { return idleness_s <= own_s; };
  const auto below = [=](double idleness_s) { return idleness_s < own_s; };
  return static_cast<double>(1 + std::count_if(before.begin(), before.end(), at_most) +
                             std::count_if(others.begin(), others.end(), below));
}

double Normalised(const Visit& visit, const Parameters& parameters) {
  const auto [least, most] = std::minmax_element(visit.idleness_s.begin(), visit.idleness_s.end());
  return *least == *most ? 0.0 : (Idleness(visit, parameters) - *least) / (*most - *least);
}

double Average(const Visit& visit, const Parameters&) {
  return -std::accumulate(visit.idleness_s.begin(), visit.idleness_s.end(), 0.0) /
         static_cast<double>(visit.idleness_s.size());
}

double Centred(const Visit& visit, const Parameters& parameters) {
  return Idleness(visit, parameters) + Average(visit, parameters);
}

double NWorst(const Visit& visit, const Parameters& parameters) {
  const double own_s = visit.idleness_s[visit.vertex];
  const auto more = std::count_if(visit.idleness_s.begin(), visit.idleness_s.end(),
                                  [=](double idleness_s) { return idleness_s > own_s; });
  return more < parameters.n_worst ? 1.0 : 0.0;
}

double FinalAverage(const Visit& visit, const Parameters& parameters) {
  return visit.last_step ? Average(visit, parameters) : 0.0;
}

enum class Scale { kTime, kRank, kNone };
enum class Settled { kOnArrival, kAtNextVisit };

struct Rule {
  RewardScheme scheme;
  std::string_view name;
  double (*value)(const Visit&, const Parameters&);
  Scale scale;
  Settled settled = Settled::kOnArrival;
};

/// All rewards there are, in the order of the enum.
constexpr std::array kRules = {
    Rule{RewardScheme::kIdleness, "idleness", Idleness, Scale::kTime},
    Rule{RewardScheme::kRanking, "ranking", Ranking, Scale::kRank},
    Rule{RewardScheme::kNormalised, "normalised", Normalised, Scale::kNone},
    Rule{RewardScheme::kCentred, "centred", Centred, Scale::kTime},
    Rule{RewardScheme::kAverage, "average", Average, Scale::kTime},
    Rule{RewardScheme::kNWorst, "n-worst", NWorst, Scale::kNone},
    Rule{RewardScheme::kFinalAverage, "final-average", FinalAverage, Scale::kTime},
    Rule{RewardScheme::kHindsight, "hindsight", Idleness, Scale::kTime, Settled::kAtNextVisit},
};

constexpr bool InOrder() {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    if (static_cast<std::size_t>(kRules[i].scheme) != i) return false;
  }
  return true;
}
static_assert(InOrder());

const Rule& RuleOf(RewardScheme scheme) { return kRules[static_cast<std::size_t>(scheme)]; }

double Factor(Scale scale, const Visit& visit, const Parameters& parameters) {
  if (scale == Scale::kTime) return 2.0 / parameters.reference_s;
  if (scale == Scale::kRank) return 1.0 / static_cast<double>(visit.idleness_s.size());
  return 1.0;
}

}  // namespace

std::vector<std::string> RewardNames() {
  std::vector<std::string> names;
  for (const Rule& rule : kRules) names.emplace_back(rule.name);
  return names;
}

RewardScheme ParseRewardScheme(const std::string& name) {
  for (const Rule& rule : kRules) {
    if (name == rule.name) return rule.scheme;
  }
  throw UsageError(
      fmt::format("the reward must be one of {}, got '{}'", fmt::join(RewardNames(), ", "), name));
}

std::string_view Name(RewardScheme scheme) { return RuleOf(scheme).name; }

float Discount(double duration_s, double horizon_s) {
  return std::max(std::numeric_limits<float>::min(),
                  static_cast<float>(std::exp(-duration_s / horizon_s)));
}

double RewardValue(RewardScheme scheme, const Visit& visit, const RewardParameters& parameters) {
  return RuleOf(scheme).value(visit, parameters);
}

float Reward(RewardScheme scheme, const Visit& visit, const RewardParameters& parameters) {
  return static_cast<float>(std::exp(-visit.travel_s / parameters.horizon_s) *
                            RewardValue(scheme, visit, parameters) *
                            Factor(RuleOf(scheme).scale, visit, parameters));
}

bool WaitsForNextVisit(RewardScheme scheme) {
  return RuleOf(scheme).settled == Settled::kAtNextVisit;
}

float HindsightReward(float reward, double next_visit_after_s, const RewardParameters& parameters) {
  // 1 − γ^Δ without cancellation for a small Δ.
  const double not_collected = -std::expm1(-next_visit_after_s / parameters.horizon_s);
  return static_cast<float>(reward * not_collected);
}

}  // namespace ronda
