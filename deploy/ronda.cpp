// `ronda`: the front command. Each subcommand adds itself; errors become one line and an exit
// status (common/base/error.h).
#include <CLI/CLI.hpp>

#include "common/base/error.h"
#include "common/nn/kernel.h"
#include "common/run/process.h"
#include "deploy/bounds_command.h"
#include "deploy/compare_command.h"
#include "deploy/config_command.h"
#include "deploy/evaluate_command.h"
#include "deploy/policy_command.h"
#include "deploy/runs_command.h"
#include "deploy/scale_command.h"
#include "deploy/status_command.h"
#include "deploy/stop_command.h"
#include "deploy/strategies_command.h"
#include "deploy/train_command.h"
#include "deploy/watch_command.h"

namespace {

int Body(int argc, char** argv, std::stop_token stop) {
  CLI::App app("Ronda: multi-robot patrolling on graphs, learned by a cluster over Fast DDS.",
               "ronda");
  app.set_version_flag("--version", "ronda " RONDA_VERSION);
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  app.footer(
      "Examples:\n"
      "  ronda train --map cumberland --agents 10 --for 90s\n"
      "  ronda evaluate --map cumberland --agents 10 --strategy sebs\n"
      "  ronda compare --map cumberland --agents 10 --strategies all\n"
      "Each command explains itself: ronda COMMAND --help");
  int exit_status = 0;
  ronda::KernelInUse();  // a wrong RONDA_KERNEL ends here, not in a child
  ronda::AddTrainCommand(app, stop, exit_status);
  ronda::AddRunsCommand(app);
  ronda::AddScaleCommand(app, stop);
  ronda::AddStatusCommand(app, exit_status);
  ronda::AddStopCommand(app, stop);
  ronda::AddWatchCommand(app, stop);
  ronda::AddEvaluateCommand(app, stop);
  ronda::AddCompareCommand(app, stop);
  ronda::AddBoundsCommand(app);
  ronda::AddStrategiesCommand(app);
  ronda::AddPolicyCommand(app);
  ronda::AddConfigCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ronda::ExitCode::kUsage);
  }
  return exit_status;
}

}  // namespace

int main(int argc, char** argv) {
  return ronda::RunProcess("ronda", [&](std::stop_token stop) { return Body(argc, argv, stop); });
}
