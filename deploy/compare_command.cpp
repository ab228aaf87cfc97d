#include "deploy/compare_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "common/evaluation/matrix_csv.h"
#include "common/evaluation/matrix_json.h"
#include "common/evaluation/matrix_markdown.h"
#include "deploy/compare_arguments.h"
#include "deploy/comparison_folder.h"
#include "deploy/matrix_plan.h"
#include "deploy/matrix_run.h"
#include "deploy/matrix_text.h"
#include "deploy/screen.h"

namespace ronda {
namespace {

MatrixLook Look() {
  if (isatty(STDOUT_FILENO) == 0) return {};
  return {.columns = Screen(false, STDOUT_FILENO).size().columns, .style = TerminalStyle()};
}

std::string Format(const Matrix& matrix, OutputFormat format) {
  if (format == OutputFormat::kCsv) return ResultsCsv(matrix);
  if (format == OutputFormat::kJson) return MatrixAsJson(matrix) + "\n";
  if (format == OutputFormat::kMarkdown) return MatrixAsMarkdown(matrix);
  return matrix.size() == 1 ? FormatComparison(matrix.front()) : MatrixAsText(matrix, Look());
}

void SayStopped(const CompareArguments& arguments, std::size_t done, std::size_t cells) {
  fmt::print(stderr, "ronda: stopped with {} of {} cells done; {}\n", done, cells,
             arguments.folder.empty()
                 ? "with --out DIR they would have been kept"
                 : fmt::format("they are kept in {}: the same command goes on", arguments.folder));
}

void RunCompare(const CompareArguments& arguments, const std::stop_token& stop) {
  const MatrixPlan plan = PlanMatrix(arguments);
  std::optional<OutputFile> json;
  if (!arguments.json_path.empty()) json.emplace(arguments.json_path);
  std::optional<ComparisonFolder> folder;
  if (!arguments.folder.empty()) folder.emplace(arguments.folder, plan.identity);
  const MatrixRun run = RunMatrix(plan, folder ? &folder->journal() : nullptr, stop);
  if (!run.matrix) return SayStopped(arguments, run.cells_done, plan.cells());
  if (json) {
    json->Write(MatrixAsJson(*run.matrix) + "\n");
    json->Commit();
  }
  if (folder) folder->WriteResults(*run.matrix);
  fmt::print("{}", Format(*run.matrix, arguments.format));
  if (arguments.figures) folder->DrawFigures(stop);
}

}  // namespace

void AddCompareCommand(CLI::App& app, std::stop_token stop) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "policies and strategies on maps, team sizes and conditions, in tables");
  AddCompareArguments(*command, *arguments);
  command->footer(
      "Options of conditions take lists too: --noise none,0.1 --speed 1,1/0.5\n"
      "Examples:\n"
      "  ronda compare --map cumberland --agents 10 --strategies all\n"
      "  ronda compare --map cumberland,grid --agents 2..12:2 --noise 0,0.1 --strategies all \\\n"
      "      --policy runs/first --out results --figures");
  command->callback([arguments, stop] { RunCompare(*arguments, stop); });
}

}  // namespace ronda
