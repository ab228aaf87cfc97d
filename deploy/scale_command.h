#pragma once
// `ronda scale`: another number of actors for a running cluster.
#include <stop_token>

namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Errors: known_run.h.
void AddScaleCommand(CLI::App& app, std::stop_token stop);

}  // namespace ronda
