#include "deploy/compare_arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "common/base/error.h"
#include "deploy/value_list.h"

namespace ronda {
namespace {

using Texts = std::vector<std::string>;

CLI::Option* AddList(CLI::App& command, const std::string& name, Texts& texts,
                     const std::string& description) {
  return command.add_option(name, texts, description)->delimiter(',')->allow_extra_args(false);
}

template <typename Value>
void AddChoice(CLI::App& command, const std::string& name, Value& value,
               const std::map<std::string, Value>& choices, const std::string& description) {
  command
      .add_option_function<std::string>(
          name, [&value, choices](const std::string& text) { value = choices.at(text); },
          description)
      ->check(CLI::IsMember(choices));
}

/// Each of the options with each of the values.
template <typename Value, typename Set>
void Cross(std::vector<EvaluationOptions>& conditions, const std::vector<Value>& values, Set set) {
  std::vector<EvaluationOptions> product;
  for (const EvaluationOptions& condition : conditions) {
    for (const Value& value : values) set(product.emplace_back(condition), value);
  }
  conditions = std::move(product);
}

}  // namespace

void AddCompareArguments(CLI::App& command, CompareArguments& arguments) {
  AddList(command, "--map", arguments.maps, "map files or shipped maps' names: a,b,c")->required();
  AddList(command, "--agents", arguments.agents,
          "numbers of robots, 1 … 10000: 2,4,6 or 1..12 or 2..12:2")
      ->required();
  AddList(command, "--noise", arguments.noise,
          "σ of travel times, each of length/speed · exp(σZ − σ²/2): 0,0.1")
      ->capture_default_str();
  AddProtocolArguments(command, arguments);
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
  AddChoice<OutputFormat>(command, "--format", arguments.format,
                          {{"text", OutputFormat::kText},
                           {"markdown", OutputFormat::kMarkdown},
                           {"csv", OutputFormat::kCsv},
                           {"json", OutputFormat::kJson}},
                          "what is printed: text (default), markdown, csv or json");
  AddChoice<RatioTo>(command, "--ratio-to", arguments.ratio_to,
                     {{"bound", RatioTo::kBound}, {"best-classical", RatioTo::kBestClassical}},
                     "tables of several settings, and markdown, give ratios to bound or "
                     "best-classical (default: seconds)");
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
  if (names.empty() && arguments.ratio_to == RatioTo::kBestClassical) {
    throw UsageError("--ratio-to best-classical needs --strategies");
  }
  return contestants;
}

std::vector<EvaluationOptions> ConditionsOf(const CompareArguments& arguments) {
  std::vector<EvaluationOptions> conditions{ResolveOptions(arguments)};
  Cross(conditions, ParseNumbers("--noise", arguments.noise),
        [](EvaluationOptions& options, double noise) { options.travel_noise = noise; });
  return conditions;
}

std::vector<std::string> MapsOf(const CompareArguments& arguments) {
  return ParseTexts("--map", arguments.maps);
}

std::vector<int> TeamSizesOf(const CompareArguments& arguments) {
  return ParseWholeNumbers("--agents", arguments.agents, 1, kMaxAgents);
}

}  // namespace ronda
