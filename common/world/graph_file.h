#pragma once
// Reads and writes maps: `.graph` files (the format of the ROS patrolling_sim) and NetworkX
// node-link JSON.
//
// What breaks a rule throws InputError with file, line (or element), rule and value. What is odd
// but has one sensible reading (a neighbour listed twice, a one-way arc, two vertices on one point,
// a parallel edge) is read, and one sentence for each is appended to `warnings`. Format facts:
// docs/maps.md.
#include <filesystem>
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

/// Reads one map file; the format follows from its name (`.graph`, or `.json`).
PatrolGraph ReadGraphFile(const std::filesystem::path& path, EdgeLengthSource length_source,
                          std::vector<std::string>* warnings);

/// The same of a file that holds `text`; nothing is opened.
PatrolGraph ParseGraphFile(std::string_view text, const std::filesystem::path& path,
                           EdgeLengthSource length_source, std::vector<std::string>* warnings);

/// The file of a map named on a command line: a path to it, or the name of a map that ships
/// (`cumberland`). `maps_dir` is where those stand. Throws InputError that lists the shipped names
/// when there is none.
std::filesystem::path FindMapFile(const std::string& name_or_path,
                                  const std::filesystem::path& maps_dir);

/// ReadGraphFile of FindMapFile.
PatrolGraph LoadMap(const std::string& name_or_path, const std::filesystem::path& maps_dir,
                    EdgeLengthSource length_source, std::vector<std::string>* warnings);

/// A map as node-link JSON that ParseGraphFile reads back to the same graph: one vertex and one
/// edge a line, `length` only where it is not what the positions say.
std::string NodeLinkText(const PatrolGraph& graph);

/// Writes that text. Throws InputError when the file cannot be written.
void WriteNodeLink(const PatrolGraph& graph, const std::filesystem::path& path);

}  // namespace ronda
