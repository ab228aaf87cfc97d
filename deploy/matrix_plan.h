#pragma once
// What a comparison will play: maps and policies loaded, every setting with every contestant
// checked.
//
// A contestant that cannot play a setting (a policy for other maps or another team) is refused
// here, before anything is played. Errors as the readers of maps and policies, naming map, team
// size and contestant; UsageError for options.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/policies/policy_file.h"
#include "deploy/compare_arguments.h"

namespace ronda {

struct PlannedMap {
  PlannedMap(const EvaluationArguments& arguments, const Conditions& conditions);

  std::string name;         // as the user gave it
  std::string fingerprint;  // of its file
  EvaluationMap map;        // with the conditions' priorities
};

/// Read once, so that all cells have the same policy also while a run goes on training it.
struct PlannedContestant {
  Contestant contestant;
  std::optional<PolicyFile> policy;  // of a policy
  std::string fingerprint;           // of its file; empty for a strategy

  std::unique_ptr<Strategy> Make(const StrategyContext& context) const;
};

struct PlannedSetting {
  const PlannedMap* map = nullptr;
  EvaluationOptions options;
};

struct MatrixPlan {
  std::string identity;  // all that determines the results, as a JSON object in one line
  std::vector<std::unique_ptr<PlannedMap>> maps;  // settings point to them
  std::vector<PlannedSetting> settings;           // in the order of Matrix
  std::vector<PlannedContestant> contestants;     // all that are played
  std::size_t shown = 0;                          // the first so many: those that were asked for

  std::size_t cells() const { return settings.size() * contestants.size(); }
};

/// Under the thesis protocol the random walk is played too, for ratios to it.
MatrixPlan PlanMatrix(const CompareArguments& arguments);

}  // namespace ronda
