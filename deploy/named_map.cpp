#include "deploy/named_map.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "common/run/paths.h"
#include "common/world/graph_file.h"

namespace ronda {

void AddLengthOption(CLI::App& command, std::string& length) {
  command
      .add_option("--length", length,
                  "edge lengths: euclidean, or file (the cost column of a .graph file)")
      ->check(CLI::IsMember({"euclidean", "file"}))
      ->capture_default_str();
}

PatrolGraph LoadNamedMap(const std::string& map, const std::string& length) {
  std::vector<std::string> warnings;
  PatrolGraph graph = LoadMap(map, MapsFolder(), ParseEdgeLengthSource(length), &warnings);
  PrintWarnings(warnings);
  return graph;
}

void PrintWarnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "ronda: warning: {}\n", warning);
}

}  // namespace ronda
