#pragma once
// `ronda map list|check|show|convert|random`: which maps ship, what a map is, and maps in another
// format, drawn by chance, or as a picture.
namespace CLI {
class App;
}

namespace ronda {

/// Adds the subcommands; they run while the command line is parsed. Throw InputError for maps and
/// traces, UsageError for outputs that cannot be written or would replace a file unasked.
void AddMapCommand(CLI::App& app);

}  // namespace ronda
