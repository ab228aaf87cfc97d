#pragma once
// The map that a command line names, read as every command reads it: warnings go to stderr. Errors
// as LoadMap and ParseEdgeLengthSource.
#include <string>
#include <vector>

#include "common/world/patrol_graph.h"

namespace ronda {

/// What an option that names a map says of itself.
inline constexpr const char* kMapHelp =
    "a map file (.graph or .json), a shipped map's name, or random:VERTICES:SEED";

PatrolGraph LoadNamedMap(const std::string& map, const std::string& length);

/// One line each, to stderr.
void PrintWarnings(const std::vector<std::string>& warnings);

}  // namespace ronda
