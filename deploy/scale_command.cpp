#include "deploy/scale_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "common/base/error.h"
#include "common/run/run_config.h"
#include "deploy/known_run.h"
#include "deploy/wanted_actors.h"

namespace ronda {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongestWait{60};

struct ScaleArguments {
  std::string run;
  int actors = 0;
};

bool IsActor(const ProcessStatus& process) { return process.role == "actor"; }

/// What the run still waits for until just `actors` actors act, with weights where there are any;
/// empty: nothing.
std::string Missing(const RunStatus& status, int actors) {
  if (status.actors_wanted != actors) return "the launcher to take it up";
  for (const ProcessStatus& process : status.processes) {
    if (!IsActor(process)) continue;
    const std::string name = ProcessName(process.role, process.index);
    if (process.state == "leaving") return name + " to hand over what it holds";
    if (process.pid == 0 || process.state == "starting") return name + " to start";
    if (process.weights_version == 0 && status.totals.weights_version > 0) {
      return "weights to reach " + name;
    }
  }
  const auto there = std::ranges::count_if(status.processes, IsActor);
  return there == actors ? "" : "actors to start";
}

void Scale(const ScaleArguments& arguments, std::stop_token stop) {
  if (arguments.actors < 1 || arguments.actors > kMaxActors) {
    throw UsageError(fmt::format("--actors: must be a whole number from 1 to {}, got {}",
                                 kMaxActors, arguments.actors));
  }
  const KnownRun before = FindRun(arguments.run);
  if (!before.launcher) {
    throw InputError(fmt::format("{}: the run is {}; there is nothing to scale", arguments.run,
                                 before.status.state));
  }
  WriteWantedActors(arguments.run, arguments.actors);
  const auto began = Clock::now();
  std::string missing;
  while (Clock::now() - began < kLongestWait && !stop.stop_requested()) {
    const KnownRun now = FindRun(arguments.run);
    if (!now.launcher) {
      throw InputError(
          fmt::format("{}: the run ended meanwhile: it is {}", arguments.run, now.status.state));
    }
    if (const int wanted = ReadWantedActors(arguments.run); wanted != arguments.actors) {
      throw InputError(
          fmt::format("{}: another command asks for {} actors meanwhile", arguments.run, wanted));
    }
    missing = Missing(now.status, arguments.actors);
    if (missing.empty()) {
      fmt::print("{}: {} → {} actors in {:.1f} s; newest weights: version {}\n", arguments.run,
                 before.status.actors_wanted, arguments.actors,
                 std::chrono::duration<double>(Clock::now() - began).count(),
                 now.status.totals.weights_version);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (stop.stop_requested()) return;
  throw Error(ExitCode::kTransport,
              fmt::format("{}: {} actors are wanted, but after {} s the run still waits for {}",
                          arguments.run, arguments.actors, kLongestWait.count(), missing));
}

}  // namespace

void AddScaleCommand(CLI::App& app, std::stop_token stop) {
  auto arguments = std::make_shared<ScaleArguments>();
  CLI::App* command = app.add_subcommand("scale", "change the number of actors of a running run");
  command->add_option("--run", arguments->run, "the run's folder")->required();
  command
      ->add_option("--actors", arguments->actors,
                   fmt::format("how many there should be, 1 to {}", kMaxActors))
      ->required();
  command->footer(
      "New actors get the newest weights at once; leaving ones end when all that they have sent is "
      "stored.\nThe number holds until the run ends.\n"
      "Example: ronda scale --run runs/first --actors 6");
  command->callback([arguments, stop] { Scale(*arguments, stop); });
}

}  // namespace ronda
