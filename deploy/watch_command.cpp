#include "deploy/watch_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "deploy/known_run.h"
#include "deploy/run_display.h"

namespace ronda {
namespace {

struct WatchArguments {
  std::string run;
  bool plain = false;
};

constexpr std::chrono::milliseconds kEvery{500};  // as often as the picture is written

void Watch(const WatchArguments& arguments, std::stop_token stop) {
  KnownRun run = FindRun(arguments.run);
  RunDisplay display(arguments.plain ? RunDisplay::Look::kPlain : RunDisplay::Look::kLive,
                     RunDisplay::Events::kInside);
  while (run.launcher && !stop.stop_requested()) {
    display.Show(run.status);
    const auto next = std::chrono::steady_clock::now() + kEvery;
    while (std::chrono::steady_clock::now() < next && !stop.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    run = FindRun(arguments.run);
  }
  display.End();
  if (!run.launcher) fmt::print("{}: the run is {}\n", arguments.run, run.status.state);
}

}  // namespace

void AddWatchCommand(CLI::App& app, std::stop_token stop) {
  auto arguments = std::make_shared<WatchArguments>();
  CLI::App* command =
      app.add_subcommand("watch", "the live view of a running run, from another terminal");
  command->add_option("--run", arguments->run, "the run's folder")->required();
  command->add_flag("--plain", arguments->plain, "a line every few seconds instead of a picture");
  command->footer("Ctrl-C ends the watching, not the run.\nExample: ronda watch --run runs/first");
  command->callback([arguments, stop] { Watch(*arguments, stop); });
}

}  // namespace ronda
