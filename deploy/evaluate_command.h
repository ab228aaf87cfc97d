#pragma once
// `ronda evaluate`: judges one policy or strategy on one map.
#include <stop_token>

namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Throws as its arguments, map and
/// policy do; returns early, with nothing written, when `stop` is requested.
void AddEvaluateCommand(CLI::App& app, std::stop_token stop);

}  // namespace ronda
