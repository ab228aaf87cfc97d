#include "deploy/matrix_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/fingerprint.h"
#include "common/nn/kernel.h"
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
  const std::vector<double> speeds_mps =
      SpeedsOf(setting.options.conditions, setting.options.agents);
  Rng rng(setting.options.seed);
  try {
    contestant.Make(map.context())->Begin(map.graph(), speeds_mps, rng);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}, {} robot{}: {}: {}", setting.map->name,
                                 setting.options.agents, setting.options.agents == 1 ? "" : "s",
                                 contestant.contestant.name, error.what()));
  }
}

/// The map with these conditions' priorities, made once.
const PlannedMap* MapUnder(MatrixPlan& plan, const EvaluationArguments& arguments,
                           const Conditions& conditions) {
  for (const PlannedSetting& setting : plan.settings) {
    if (setting.map->name == arguments.map &&
        setting.options.conditions.priorities == conditions.priorities) {
      return setting.map;
    }
  }
  return plan.maps.emplace_back(std::make_unique<PlannedMap>(arguments, conditions)).get();
}

std::string IdentityOf(const MatrixPlan& plan, const CompareArguments& arguments) {
  nlohmann::ordered_json identity{{"version", RONDA_VERSION},
                                  {"protocol", arguments.protocol},
                                  {"horizon_s", plan.settings.front().options.horizon_s},
                                  {"episodes", arguments.options.episodes},
                                  {"seed", arguments.options.seed},
                                  {"length", arguments.length},
                                  {"agents", TeamSizesOf(arguments)}};
  for (const auto& map : plan.maps) identity["maps"][map->name] = map->fingerprint;
  auto& conditions = identity["conditions"] = nlohmann::ordered_json::object();
  for (const auto& [name, text] : arguments.conditions) {
    if (!text.empty()) conditions[name] = text;
  }
  auto& policies = identity["policies"] = nlohmann::ordered_json::object();
  auto& strategies = identity["strategies"] = nlohmann::ordered_json::array();
  for (const PlannedContestant& each : plan.contestants) {
    if (each.policy) {
      policies[each.contestant.name] =
          fmt::format("{} {}", each.fingerprint, NameOf(KernelInUse()));
    } else {
      strategies.push_back(each.contestant.name);
    }
  }
  return identity.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

PlannedMap::PlannedMap(const EvaluationArguments& arguments, const Conditions& conditions)
    : name(arguments.map),
      fingerprint(FileFingerprint(FindMapFile(name, MapsFolder()))),
      map(arguments, conditions) {}

std::unique_ptr<Strategy> PlannedContestant::Make(const StrategyContext& context) const {
  return policy ? MakePolicyStrategy(*policy, context) : MakeStrategy(contestant.name, context);
}

MatrixPlan PlanMatrix(const CompareArguments& arguments) {
  MatrixPlan plan;
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
  CompareArguments of_map = arguments;
  for (const std::string& name : MapsOf(arguments)) {
    of_map.map = name;
    for (EvaluationOptions options : conditions) {
      for (const int agents : team_sizes) {
        options.agents = agents;
        CheckOptions(options);
        plan.settings.push_back({MapUnder(plan, of_map, options.conditions), options});
      }
    }
  }
  for (const PlannedSetting& setting : plan.settings) {
    for (const PlannedContestant& each : plan.contestants) CheckCanPlay(each, setting);
  }
  plan.identity = IdentityOf(plan, arguments);
  return plan;
}

}  // namespace ronda
