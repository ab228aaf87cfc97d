#pragma once
// Reads and writes maps: `.graph` files (the format of the ROS patrolling_sim) and NetworkX
// node-link JSON.
//
// What breaks a rule throws InputError with file, line (or element), rule and value. What is odd
// but has one sensible reading (a neighbour listed twice, a one-way arc, two vertices on one point,
// a parallel edge) is read, and one sentence for each is appended to `warnings`. Format facts:
// docs/maps.md.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/world/patrol_graph.h"

namespace ronda {

/// Ends closer than this count as one point, and an edge between them is taken as this long.
inline constexpr double kSamePoint_m = 1e-3;

enum class EdgeLengthSource {
  kEuclidean,  // the distance between the ends (thesis §1.3); an explicit JSON `length` wins over
               // it
  kFile,       // the cost column of a `.graph` file (px, times metres per px); JSON must then give
               // `length`
};

/// "euclidean" or "file"; else InputError.
EdgeLengthSource ParseEdgeLengthSource(const std::string& name);

/// The names of the maps that ship, ascending.
std::vector<std::string> ShippedMaps(const std::filesystem::path& maps_dir);

/// Reads one map file; the format follows from its name (`.graph`, or `.json`).
PatrolGraph ReadGraphFile(const std::filesystem::path& path, EdgeLengthSource length_source,
                          std::vector<std::string>* warnings);

/// The same of a file that holds `text`; nothing is opened.
PatrolGraph ParseGraphFile(std::string_view text, const std::filesystem::path& path,
                           EdgeLengthSource length_source, std::vector<std::string>* warnings);

/// The file of a map named on a command line: a path to it, or the name of a map that ships
/// (`cumberland`); nullopt for `random:VERTICES:SEED`, which has none. `maps_dir` is where those
/// that ship stand. Throws InputError that lists them when there is no such map.
std::optional<std::filesystem::path> FindMapFile(const std::string& name_or_path,
                                                 const std::filesystem::path& maps_dir);

/// ReadGraphFile of FindMapFile, or the random map.
PatrolGraph LoadMap(const std::string& name_or_path, const std::filesystem::path& maps_dir,
                    EdgeLengthSource length_source, std::vector<std::string>* warnings);

/// A map as node-link JSON that ParseGraphFile reads back to the same graph: one vertex and one
/// edge a line, `length` only where it is not the distance between the ends, `priority` only where
/// not all are alike.
std::string NodeLinkText(const PatrolGraph& graph);

/// The writers: the file appears whole or not at all, and one that is there is replaced. Throw
/// InputError when it cannot be written.

/// That text.
void WriteNodeLink(const PatrolGraph& graph, const std::filesystem::path& path);

/// As a `.graph` file: the same edges and `metres_per_px`, positions and lengths (those read with
/// EdgeLengthSource::kFile) within 1e-12 of the map's extent. What the format cannot hold is
/// appended to `warnings`, one sentence for each kind.
void WriteDotGraph(const PatrolGraph& graph, const std::filesystem::path& path,
                   std::vector<std::string>* warnings);

}  // namespace ronda
