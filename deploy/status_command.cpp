#include "deploy/status_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "common/evaluation/output_file.h"
#include "deploy/known_run.h"
#include "deploy/live_view.h"
#include "deploy/screen.h"

namespace ronda {
namespace {

struct StatusArguments {
  std::string run;
  std::string json;
};

constexpr int kDegraded = 1;

int Status(const StatusArguments& arguments) {
  const KnownRun run = FindRun(arguments.run);
  if (!arguments.json.empty()) {
    OutputFile file(arguments.json);
    file.Write(RunStatusAsJson(run.status));
    file.Commit();
  }
  constexpr ViewSize kEverything{.columns = 160, .rows = 1000};
  const auto lines = RenderRunStatus(run.status, kEverything, ViewStyle::kPlain,
                                     UtcOffset(run.status.written_unix_s));
  for (const std::string& line : lines) fmt::print("{}\n", line);
  return run.status.problems.empty() ? 0 : kDegraded;
}

}  // namespace

void AddStatusCommand(CLI::App& app, int& exit_status) {
  auto arguments = std::make_shared<StatusArguments>();
  CLI::App* command =
      app.add_subcommand("status", "how a run goes: processes, channels, what is the matter");
  command->add_option("--run", arguments->run, "the run's folder")->required();
  command->add_option("--json", arguments->json, "write everything to this file too");
  command->footer(
      "Exit status: 0 healthy or ended as asked, 1 degraded, 3 no such run.\n"
      "Example: ronda status --run runs/first");
  command->callback([arguments, &exit_status] { exit_status = Status(*arguments); });
}

}  // namespace ronda
