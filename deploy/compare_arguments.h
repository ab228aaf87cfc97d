#pragma once
// The options of `ronda compare`, and the lists that they stand for.
//
// --map, --agents, --strategies and every option of a condition take lists; the conditions that are
// played are the cross product of theirs. Errors: UsageError that names option, rule and value.
#include <string>
#include <vector>

#include "deploy/evaluation_arguments.h"

namespace ronda {

enum class OutputFormat { kText, kMarkdown, kCsv, kJson };

struct CompareArguments : EvaluationArguments {  // of which map and agents stay unused, and the
                                                 // texts of conditions are lists
  std::vector<std::string> maps;
  std::vector<std::string> agents;
  std::vector<std::string> policies;
  std::vector<std::string> strategies;
  std::string folder;  // empty: none
  bool figures = false;
  OutputFormat format = OutputFormat::kText;
};

/// `arguments` must live as long as the command.
void AddCompareArguments(CLI::App& command, CompareArguments& arguments);

/// Policies first, then strategies; at least one, each once.
std::vector<Contestant> ContestantsOf(const CompareArguments& arguments);

/// Options for one robot under each condition, each once; the first option's values vary slowest.
/// Not checked: what robots may fail depends on the team.
std::vector<EvaluationOptions> ConditionsOf(const CompareArguments& arguments);

std::vector<std::string> MapsOf(const CompareArguments& arguments);
std::vector<int> TeamSizesOf(const CompareArguments& arguments);

}  // namespace ronda
