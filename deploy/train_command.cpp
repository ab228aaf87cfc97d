#include "deploy/train_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <memory>

#include "common/base/whole_file.h"
#include "common/run/duration.h"
#include "common/run/run_folder.h"
#include "deploy/named_map.h"
#include "deploy/run_state.h"
#include "deploy/train_setup.h"
#include "deploy/training_run.h"

namespace ronda {
namespace {

struct TrainCommandArguments : TrainArguments {
  bool print_config = false;
  bool plain = false;
};

int Train(const TrainCommandArguments& arguments, std::stop_token stop) {
  const auto path =
      arguments.run_folder
          ? std::filesystem::path(*arguments.run_folder)
          : RunFolder::DefaultPath(arguments.map.value_or("cumberland"), std::time(nullptr));
  std::optional<std::filesystem::path> stored;
  if (std::filesystem::exists(path / "config.toml")) stored = path / "config.toml";
  const TrainSetup setup(arguments,
                         stored);  // before the folder is made: bad input leaves no trace
  if (arguments.print_config) {
    fmt::print("{}", setup.config().Resolved());
    return 0;
  }
  const RunFolder folder(path);
  const RunState state = ReadRunState(path);
  if (Progress(setup.run(), state.training_s, state.totals.decisions) >= 1.0) {
    fmt::print(
        "{}: this run has its {} of training and {} decisions already; a larger --for or "
        "--decisions goes on.\n",
        path.string(), FormatDuration(state.training_s), state.totals.decisions);
    return 0;
  }
  WriteWholeFile(folder.config_file(), setup.config().Resolved());
  return RunTraining(setup, folder,
                     arguments.plain ? RunDisplay::Look::kPlain : RunDisplay::Look::kLive,
                     std::move(stop));
}

}  // namespace

void AddTrainCommand(CLI::App& app, std::stop_token stop, int& exit_status) {
  auto arguments = std::make_shared<TrainCommandArguments>();
  CLI::App* command = app.add_subcommand(
      "train", "train a policy: replay, learner and actors as processes of their own");
  command->add_option("--map", arguments->map, fmt::format("{} (cumberland)", kMapHelp));
  command->add_option("--agents", arguments->agents, "robots on the map (10)");
  command->add_option("--actors", arguments->actors, "actor processes (one for each core)");
  command->add_option("--algorithm", arguments->algorithm, "dqn");
  command->add_option("--for", arguments->seconds,
                      "training time of the run in all: 90s, 5m, 1h (90s)");
  command->add_option("--decisions", arguments->decisions, "decisions of the run in all");
  command->add_option("--run", arguments->run_folder,
                      "run folder; one that is there goes on (runs/<map>-<time>)");
  command->add_option("--seed", arguments->seed, "all random choices follow from it (1)");
  command->add_option("--config", arguments->config_file, "a TOML file for a new run");
  command->add_option("--set", arguments->settings, "one key of the configuration: KEY=VALUE");
  command->add_flag("--print-config", arguments->print_config,
                    "print the configuration that the run would have, and stop");
  command->add_flag("--plain", arguments->plain,
                    "a line every few seconds instead of the live view");
  command->footer(
      "Ctrl-C stops with a checkpoint; the same command goes on.\n"
      "Example: ronda train --map cumberland --agents 10 --actors 2 --for 90s --run runs/first");
  command->callback([arguments, stop, &exit_status] { exit_status = Train(*arguments, stop); });
}

}  // namespace ronda
