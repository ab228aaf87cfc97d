#pragma once
// How short a closed walk through all vertices can be at least: the lower value beside the walk
// that FindShortestClosedWalk finds.
//
// The largest of what can be proved: the covering linear programme (common/world/covering_bound.h),
// and minimum 1-trees over shortest-path distances, improved by subgradients (Held & Karp 1970,
// 1971; steps after Volgenant & Jonker 1982). A 1-tree is a certificate for any multipliers, so the
// value holds however early the search ends. Pure; O(V²) an iteration, 5000 of them up to V = 141,
// then fewer; 0.2 s from there on. Source: docs/bounds.md.
#include <string>

#include "common/world/patrol_graph.h"
#include "common/world/shortest_paths.h"

namespace ronda {

struct ClosedWalkBound {
  double length_m = 0.0;
  std::string method;
};

/// `paths` are those of `graph`.
ClosedWalkBound ClosedWalkLowerBound(const PatrolGraph& graph, const ShortestPaths& paths);

/// The part of the 1-trees; 0 for two vertices. Any number of iterations gives a bound.
double OneTreeBound_m(const ShortestPaths& paths, int iterations);

}  // namespace ronda
