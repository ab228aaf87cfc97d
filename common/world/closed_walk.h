#pragma once
// The shortest closed walk through all vertices: exact where a map came with one, else the best of
// many local searches.
//
// On the metric closure it is the travelling-salesman problem: nearest-neighbour starts, 2-opt and
// Or-opt (Croes 1958, Or 1976), random restarts from a fixed seed. The result is an upper value,
// and says so. About 1 s at |V| = 1000.
#include <cstdint>

#include "common/world/patrol_graph.h"
#include "common/world/shortest_paths.h"

namespace ronda {

/// The walk that came with the map, else the one that FindShortClosedWalk finds with seed 1.
ClosedWalk ClosedWalkOf(const PatrolGraph& graph, const ShortestPaths& paths);

ClosedWalk FindShortClosedWalk(const PatrolGraph& graph, const ShortestPaths& paths,
                               std::uint64_t seed);

}  // namespace ronda
