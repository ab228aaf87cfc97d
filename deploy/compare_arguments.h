#pragma once
// The options of `ronda compare`, and the lists that they stand for.
//
// Every option of a condition takes a list; conditions are the cross product of all of them. A new
// condition is an axis: its list here, and its line in ConditionsOf.
// Errors: UsageError that names option, rule and value.
#include <string>
#include <vector>

#include "common/evaluation/matrix_table.h"
#include "deploy/evaluation_arguments.h"

namespace ronda {

enum class OutputFormat { kText, kMarkdown, kCsv, kJson };

struct CompareArguments : EvaluationArguments {  // of which map, agents and noise stay unused
  std::vector<std::string> maps;
  std::vector<std::string> agents;
  std::vector<std::string> noise{"0"};
  std::vector<std::string> policies;
  std::vector<std::string> strategies;
  std::string folder;  // empty: none
  bool figures = false;
  OutputFormat format = OutputFormat::kText;
  RatioTo ratio_to = RatioTo::kNothing;
};

/// `arguments` must live as long as the command.
void AddCompareArguments(CLI::App& command, CompareArguments& arguments);

/// Policies first, then strategies; at least one, each once.
std::vector<Contestant> ContestantsOf(const CompareArguments& arguments);

/// Options for one robot under each condition, checked; the first option's values vary slowest.
std::vector<EvaluationOptions> ConditionsOf(const CompareArguments& arguments);

std::vector<std::string> MapsOf(const CompareArguments& arguments);
std::vector<int> TeamSizesOf(const CompareArguments& arguments);

}  // namespace ronda
