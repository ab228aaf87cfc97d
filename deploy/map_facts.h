#pragma once
// What there is to say of a map before anybody patrols it, as text and as JSON (keys:
// docs/maps.md). Pure; O(V²) memory, a second at V = 1000, a minute or two at V = 10 000 where the
// map brings no closed walk.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/world/patrol_graph.h"

namespace ronda {

struct Range {
  double least = 0.0;
  double mean = 0.0;
  double most = 0.0;
};

struct MapFacts {
  std::string name;
  std::string source;  // may be empty
  int vertices = 0;
  int edges = 0;
  int leaves = 0;  // vertices of degree 1
  Range degree;
  Range edge_m;
  double total_m = 0.0;     // all edges
  double diameter_m = 0.0;  // the longest of the shortest paths
  Position low;             // corners of the bounding box
  Position high;
  double metres_per_px = 1.0;
  double closed_walk_m = 0.0;
  std::string closed_walk_source;
  Range priority;  // 1 where all are alike
};

MapFacts FactsOf(const PatrolGraph& graph);

/// A few lines.
std::string FormatFacts(const MapFacts& facts);
/// "47.9 × 31.2 m".
std::string FormatSize(const MapFacts& facts);

nlohmann::ordered_json FactsAsJson(const MapFacts& facts);

}  // namespace ronda
