#pragma once
// `ronda bounds`: how good a team can be at best on one map: lower bounds on AGI and WI, and the
// shortest closed walk from both sides.
namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommand; it runs while the command line is parsed. Throws as its arguments and map
/// do.
void AddBoundsCommand(CLI::App& app);

}  // namespace ronda
