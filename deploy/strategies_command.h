#pragma once
// `ronda strategies`: the classical strategies that there are, with their rule, what their robots
// know, and who described them.
namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Throws InputError where the JSON
/// file cannot be written.
void AddStrategiesCommand(CLI::App& app);

}  // namespace ronda
