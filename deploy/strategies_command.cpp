#include "deploy/strategies_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "common/evaluation/output_file.h"
#include "common/world/strategies/strategy.h"
#include "deploy/text_table.h"

namespace ronda {
namespace {

std::string AsText() {
  std::vector<TableRow> rows;
  for (const StrategyInfo& info : KnownStrategies()) {
    rows.push_back({{std::string(info.name)},
                    {std::string(info.rule)},
                    {std::string(info.knowledge)},
                    {std::string(info.source)}});
  }
  std::string text;
  for (const StyledLine& line : TableLines({{"name"}, {"rule"}, {"knows"}, {"source"}}, rows)) {
    text += line.Draw(line.columns(), ViewStyle::kPlain) + "\n";
  }
  return text;
}

std::string AsJson() {
  auto list = nlohmann::ordered_json::array();
  for (const StrategyInfo& info : KnownStrategies()) {
    list.push_back({{"name", info.name},
                    {"rule", info.rule},
                    {"knowledge", info.knowledge},
                    {"paper", info.source},
                    {"in_all", !info.is_variant()}});
  }
  return list.dump(2) + "\n";
}

void ListStrategies(const std::string& json_path) {
  if (!json_path.empty()) {
    OutputFile json(json_path);
    json.Write(AsJson());
    json.Commit();
  }
  fmt::print("{}", AsText());
}

}  // namespace

void AddStrategiesCommand(CLI::App& app) {
  auto json_path = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("strategies", "the classical strategies: rule, knowledge, source");
  command->add_option("--json", *json_path, "write the list to this file");
  command->footer(
      "`all` stands for those before cr:shared.\nExample:\n  ronda strategies --json list.json");
  command->callback([json_path] { ListStrategies(*json_path); });
}

}  // namespace ronda
