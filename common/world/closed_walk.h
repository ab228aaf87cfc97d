#pragma once
// A short closed walk through all vertices of a patrol graph: the tour that cyclic strategies
// follow, and the L_tsp that the steady protocol's reference time rests on.
//
// The walk is a travelling-salesman tour on the metric closure (shortest-path distances), found by
// 2-opt (Croes 1958) and Or-opt (Or 1976) from many starts, then expanded to walk along edges; what
// comes out is an upper value of the shortest. O(V²) memory beyond the paths; about a second at
// V = 1000. Deterministic in the seed. Pure functions.
#include <cstdint>

#include "common/world/patrol_graph.h"
#include "common/world/shortest_paths.h"

namespace ronda {

/// `paths` are those of `graph`.
ClosedWalk FindShortestClosedWalk(const PatrolGraph& graph, const ShortestPaths& paths,
                                  std::uint64_t seed);

/// The walk that came with the map, else one found with a fixed seed; `source` says which.
ClosedWalk ClosedWalkOf(const PatrolGraph& graph, const ShortestPaths& paths);

}  // namespace ronda
