#include "deploy/matrix_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/base/fingerprint.h"
#include "common/run/paths.h"
#include "common/team/policy_strategy.h"
#include "deploy/find_policy.h"

namespace ronda {
namespace {

PlannedContestant Load(const Contestant& contestant) {
  PlannedContestant planned{.contestant = contestant, .policy = std::nullopt, .fingerprint = {}};
  if (contestant.kind == ContestantKind::kPolicy) {
    const std::filesystem::path file = FindPolicyFile(contestant.name);
    planned.fingerprint = FileFingerprint(file);
    planned.policy = ReadPolicyFile(file);
  }
  return planned;
}

std::vector<PlannedContestant> LoadContestants(const CompareArguments& arguments) {
  std::vector<PlannedContestant> planned;
  for (const Contestant& each : ContestantsOf(arguments)) planned.push_back(Load(each));
  return planned;
}

/// Throws where the contestant cannot begin an episode of the setting.
void CheckCanPlay(const PlannedContestant& contestant, const PlannedSetting& setting) {
  const EvaluationMap& map = setting.map->map;
  const std::vector<double> speeds_mps(static_cast<std::size_t>(setting.options.agents),
                                       setting.options.speed_mps);
  Rng rng(setting.options.seed);
  try {
    contestant.Make(map.context())->Begin(map.graph(), speeds_mps, rng);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}, {} robot{}: {}: {}", setting.map->name,
                                 setting.options.agents, setting.options.agents == 1 ? "" : "s",
                                 contestant.contestant.name, error.what()));
  }
}

}  // namespace

PlannedMap::PlannedMap(const std::string& name_given, const std::string& length)
    : name(name_given),
      fingerprint(FileFingerprint(FindMapFile(name, MapsFolder()))),
      map(name, length) {}

std::unique_ptr<Strategy> PlannedContestant::Make(const StrategyContext& context) const {
  return policy ? MakePolicyStrategy(*policy, context) : MakeStrategy(contestant.name, context);
}

MatrixPlan PlanMatrix(const CompareArguments& arguments) {
  MatrixPlan plan;
  plan.length = arguments.length;
  const std::vector<EvaluationOptions> conditions = ConditionsOf(arguments);
  const std::vector<int> team_sizes = TeamSizesOf(arguments);
  plan.contestants = LoadContestants(arguments);
  plan.shown = plan.contestants.size();
  const PlannedContestant random = Load({.name = "random"});
  if (conditions.front().protocol == Protocol::kThesis &&
      std::ranges::find(plan.contestants, random.contestant, &PlannedContestant::contestant) ==
          plan.contestants.end()) {
    plan.contestants.push_back(random);
  }
  for (const std::string& name : MapsOf(arguments)) {
    plan.maps.push_back(std::make_unique<PlannedMap>(name, arguments.length));
    for (const EvaluationOptions& condition : conditions) {
      for (const int agents : team_sizes) {
        PlannedSetting& setting = plan.settings.emplace_back(plan.maps.back().get(), condition);
        setting.options.agents = agents;
        CheckOptions(setting.options);
      }
    }
  }
  for (const PlannedSetting& setting : plan.settings) {
    for (const PlannedContestant& each : plan.contestants) CheckCanPlay(each, setting);
  }
  return plan;
}

}  // namespace ronda
