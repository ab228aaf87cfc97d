#pragma once
// `ronda policy info FILE` and `ronda policy extract RUN FILE`: what a policy file says of itself,
// and a run's policy as one file to keep or to hand on.
namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommands; they run while the command line is parsed. Throw InputError where there is
/// no policy, CheckpointError where it cannot be read or written, UsageError where an output would
/// replace a file unasked.
void AddPolicyCommand(CLI::App& app);

}  // namespace ronda
