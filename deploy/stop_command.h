#pragma once
// `ronda stop`: ends a running cluster, with a checkpoint.
#include <stop_token>

namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Errors: known_run.h.
void AddStopCommand(CLI::App& app, std::stop_token stop);

}  // namespace ronda
