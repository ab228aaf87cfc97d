#include "deploy/compare_arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <sstream>

#include "common/base/error.h"
#include "common/world/conditions_text.h"
#include "deploy/value_list.h"

namespace ronda {
namespace {

using Texts = std::vector<std::string>;

CLI::Option* AddList(CLI::App& command, const std::string& name, Texts& texts,
                     const std::string& description) {
  return command.add_option(name, texts, description)->delimiter(',')->allow_extra_args(false);
}

const std::map<std::string, OutputFormat> kFormats{{"text", OutputFormat::kText},
                                                   {"markdown", OutputFormat::kMarkdown},
                                                   {"csv", OutputFormat::kCsv},
                                                   {"json", OutputFormat::kJson}};

/// The parts that commas separate; none of an empty text.
Texts Split(const std::string& text) {
  Texts parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  if (text.ends_with(',')) parts.emplace_back();
  return parts;
}

/// Each of the options with each value of a condition.
std::vector<EvaluationOptions> Cross(const std::vector<EvaluationOptions>& conditions,
                                     const std::string& name, const Texts& values) {
  std::vector<EvaluationOptions> product;
  for (const EvaluationOptions& condition : conditions) {
    for (const std::string& value : values) {
      SetCondition(product.emplace_back(condition).conditions, name, value);
    }
  }
  return product;
}

}  // namespace

void AddCompareArguments(CLI::App& command, CompareArguments& arguments) {
  AddList(command, "--map", arguments.maps, "map files or shipped maps' names: a,b,c")->required();
  AddList(command, "--agents", arguments.agents,
          "numbers of robots, 1 … 10000: 2,4,6 or 1..12 or 2..12:2")
      ->required();
  AddEvaluationArguments(command, arguments);
  command
      .add_option("--policy", arguments.policies,
                  "a run folder, a policy file or a shipped policy's name; may be repeated")
      ->allow_extra_args(false);
  AddList(command, "--strategies", arguments.strategies,
          "all, or a comma-separated list of " + StrategyNames());
  auto* folder = command.add_option("--out", arguments.folder,
                                    "a folder for results.{csv,json,md}, episodes.csv and what is "
                                    "done; the same command goes on");
  command.add_flag("--figures", arguments.figures, "draw pictures into the folder")->needs(folder);
  command
      .add_option_function<std::string>(
          "--format",
          [&arguments](const std::string& text) { arguments.format = kFormats.at(text); },
          "what is printed: text (default), markdown, csv or json")
      ->check(CLI::IsMember(kFormats));
}

std::vector<Contestant> ContestantsOf(const CompareArguments& arguments) {
  std::vector<Contestant> contestants;
  for (const std::string& name : ParseTexts("--policy", arguments.policies)) {
    contestants.push_back({.kind = ContestantKind::kPolicy, .name = name});
  }
  Texts names;
  for (const std::string& name : ParseTexts("--strategies", arguments.strategies)) {
    const Texts meant = name == "all" ? AllStrategyNames() : Texts{name};
    names.insert(names.end(), meant.begin(), meant.end());
  }
  for (const std::string& name : ParseTexts("--strategies", names)) {
    contestants.push_back({.kind = ContestantKind::kStrategy, .name = name});
  }
  if (contestants.empty()) throw UsageError("nothing to compare: give --policy or --strategies");
  return contestants;
}

std::vector<EvaluationOptions> ConditionsOf(const CompareArguments& arguments) {
  CompareArguments without = arguments;
  without.conditions.clear();
  std::vector<EvaluationOptions> conditions{ResolveOptions(without)};
  for (const ConditionOption& option : ConditionOptions()) {
    const auto given = arguments.conditions.find(option.name);
    if (given == arguments.conditions.end() || given->second.empty()) continue;
    conditions = Cross(conditions, option.name,
                       ParseTexts(fmt::format("--{}", option.name), Split(given->second)));
  }
  std::vector<EvaluationOptions> once;
  for (const EvaluationOptions& each : conditions) {
    const bool known =
        std::ranges::find(once, each.conditions, &EvaluationOptions::conditions) != once.end();
    if (!known) once.push_back(each);
  }
  return once;
}

std::vector<std::string> MapsOf(const CompareArguments& arguments) {
  return ParseTexts("--map", arguments.maps);
}

std::vector<int> TeamSizesOf(const CompareArguments& arguments) {
  return ParseWholeNumbers("--agents", arguments.agents, 1, kMaxAgents);
}

}  // namespace ronda
