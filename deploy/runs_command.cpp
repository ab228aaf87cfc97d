#include "deploy/runs_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "common/evaluation/output_file.h"
#include "common/run/duration.h"
#include "common/run/unix_time.h"
#include "deploy/known_run.h"
#include "deploy/text_table.h"
#include "deploy/totals_json.h"

namespace ronda {
namespace {

struct RunsArguments {
  std::string root = "runs";
  std::string json;
};

std::optional<double> AgeS(const RunStatus& status) {
  if (status.begun_unix_s == 0.0) return std::nullopt;
  return std::max(0.0, UnixNow() - status.begun_unix_s);
}

std::string AsText(const std::vector<KnownRun>& runs) {
  const auto seconds = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2f} s", *value) : std::string();
  };
  std::vector<TableRow> rows;
  for (const KnownRun& run : runs) {
    const RunStatus& status = run.status;
    const auto age_s = AgeS(status);
    rows.push_back({{run.folder.string()},
                    {status.map},
                    {std::to_string(status.agents)},
                    {std::to_string(status.actors_wanted)},
                    {age_s ? FormatDuration(*age_s) : ""},
                    {seconds(status.best_agi_s)},
                    {seconds(status.best_classical_agi_s)},
                    {status.state},
                    {status.problems.empty() ? "" : status.problems.front()}});
  }
  const std::vector<TableColumn> columns{{"run"},
                                         {"map"},
                                         {"agents", Align::kRight},
                                         {"actors", Align::kRight},
                                         {"age", Align::kRight},
                                         {"best AGI", Align::kRight},
                                         {"best classical", Align::kRight},
                                         {"state"},
                                         {"problem"}};
  std::string text;
  for (const StyledLine& line : TableLines(columns, rows))
    text += line.Draw(line.columns(), ViewStyle::kPlain) + "\n";
  return text;
}

std::string AsJson(const std::vector<KnownRun>& runs) {
  auto json = nlohmann::json::array();
  for (const KnownRun& run : runs) {
    const RunStatus& status = run.status;
    json.push_back({{"run", run.folder.string()},
                    {"map", status.map},
                    {"agents", status.agents},
                    {"actors", status.actors_wanted},
                    {"age_s", AgeS(status)},
                    {"training_s", status.training_s},
                    {"best_agi_s", status.best_agi_s},
                    {"best_classical_agi_s", status.best_classical_agi_s},
                    {"state", status.state},
                    {"problems", status.problems}});
  }
  return json.dump(1) + "\n";
}

void Runs(const RunsArguments& arguments) {
  const std::vector<KnownRun> runs = FindRuns(arguments.root);
  if (!arguments.json.empty()) {
    OutputFile file(arguments.json);
    file.Write(AsJson(runs));
    file.Commit();
  }
  if (runs.empty()) {
    fmt::print("no runs below {}\n", arguments.root);
  } else {
    fmt::print("{}", AsText(runs));
  }
}

}  // namespace

void AddRunsCommand(CLI::App& app) {
  auto arguments = std::make_shared<RunsArguments>();
  CLI::App* command = app.add_subcommand("runs", "list the runs: map, robots, age, AGI, state");
  command->add_option("--root", arguments->root, "the folder that holds run folders (runs)");
  command->add_option("--json", arguments->json, "write the list to this file too");
  command->footer("Example: ronda runs");
  command->callback([arguments] { Runs(*arguments); });
}

}  // namespace ronda
