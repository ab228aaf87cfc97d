#pragma once
// `ronda watch`: the live view of a run, from another terminal.
#include <stop_token>

namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Errors: known_run.h.
void AddWatchCommand(CLI::App& app, std::stop_token stop);

}  // namespace ronda
