#pragma once
// `ronda compare`: policies and strategies on maps, team sizes and conditions, in tables.
#include <stop_token>

namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Throws as its arguments, map and
/// policies do; returns early, with nothing but the journal of --out written, when `stop` is
/// requested.
void AddCompareCommand(CLI::App& app, std::stop_token stop);

}  // namespace ronda
