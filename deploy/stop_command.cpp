#include "deploy/stop_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>

#include "common/base/error.h"
#include "deploy/known_run.h"

namespace ronda {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongestWait{60};  // a launcher needs about one

void Stop(const std::string& folder, std::stop_token stop) {
  const KnownRun before = FindRun(folder);
  if (!before.launcher) {
    fmt::print("{}: the run is {} already\n", folder, before.status.state);
    return;
  }
  ::kill(*before.launcher, SIGTERM);
  const auto began = Clock::now();
  while (!stop.stop_requested()) {
    const KnownRun now = FindRun(folder);
    if (now.launcher != before.launcher) {
      fmt::print("{}: {} after {} decisions and {} updates; the same command goes on\n", folder,
                 now.status.state, now.status.totals.decisions, now.status.updates);
      return;
    }
    if (Clock::now() - began > kLongestWait) {
      throw Error(ExitCode::kTransport,
                  fmt::format("{}: its launcher (process {}) was asked to stop and still runs "
                              "after {} s",
                              folder, *before.launcher, kLongestWait.count()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

void AddStopCommand(CLI::App& app, std::stop_token stop) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("stop", "end a running run, with a checkpoint");
  command->add_option("--run", *folder, "the run's folder")->required();
  command->footer("Example: ronda stop --run runs/first");
  command->callback([folder, stop] { Stop(*folder, stop); });
}

}  // namespace ronda
