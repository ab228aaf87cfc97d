#pragma once
// `ronda runs`: the runs that there are.
namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Errors: known_run.h.
void AddRunsCommand(CLI::App& app);

}  // namespace ronda
