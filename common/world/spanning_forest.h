#pragma once
// A lower bound on the worst idleness from how far the vertices lie apart: N walks that visit a set
// of vertices are no shorter than a forest of N trees that joins the set over shortest paths.
//
// In any stretch of time as long as the worst idleness W, every vertex is visited, or stood at;
// those of weight w and more in any stretch of W / w. Robots may stand still. Kruskal's tree is
// exact, so nothing is searched for. Pure; O(E log V), with priorities O(V² log V) (0.2 s at
// V = 1000). Source: docs/bounds.md.
#include "common/world/patrol_graph.h"
#include "common/world/shortest_paths.h"

namespace ronda {

/// Times the sum of the robots' speeds: WI ≥ this / Σ speeds. `paths` are those of `graph`.
double SpanningForestBound_m(const PatrolGraph& graph, const ShortestPaths& paths, int robots);

}  // namespace ronda
