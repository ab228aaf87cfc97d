#pragma once
// The map that a command line names: its options, and how every command reads it: warnings go to
// stderr. Errors as LoadMap and ParseEdgeLengthSource.
#include <string>
#include <vector>

#include "common/world/patrol_graph.h"

namespace CLI {
class App;
}

namespace ronda {

/// What an option that names a map says of itself.
inline constexpr const char* kMapHelp =
    "a map file (.graph or .json), a shipped map's name, or random:VERTICES:SEED";

/// `--length`, into `length`, which must live as long as the command.
void AddLengthOption(CLI::App& command, std::string& length);

/// `length` as ParseEdgeLengthSource.
PatrolGraph LoadNamedMap(const std::string& map, const std::string& length);

/// One line each, to stderr.
void PrintWarnings(const std::vector<std::string>& warnings);

}  // namespace ronda
