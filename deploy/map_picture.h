#pragma once
// A map as a picture (SVG 1.1): vertices, edges, ids where they can be read, a scale bar, and one
// quantity as colour with its legend.
//
// Equal scale in both directions; y points up, as the words of the compass in `.graph` files have
// it. Vertices and edges tell their ids and values where the pointer rests on them. Any id is fine.
// Pure; O(V + E log E).
#include <string>
#include <vector>

#include "common/world/patrol_graph.h"

namespace ronda {

/// What the colours say: a value for each vertex, for each edge, or neither. Finite.
struct MapColours {
  std::string label;                // with its unit, for the legend
  std::vector<double> of_vertices;  // (V) or empty
  std::vector<double> of_edges;  // (E) or empty; ≥ 0, shown as width too: the scale begins at 0
};

enum class ShowIds { kWhereLegible, kAlways };

std::string DrawMap(const PatrolGraph& graph, const MapColours& colours, ShowIds ids);

}  // namespace ronda
