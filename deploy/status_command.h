#pragma once
// `ronda status`: how a run goes, process by process; exit status 0 healthy, 1 degraded, 3 no such
// run.
namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Errors: known_run.h.
void AddStatusCommand(CLI::App& app, int& exit_status);

}  // namespace ronda
