#pragma once
// A tour through some vertices of a patrol graph, at most 1.5 times as long as the shortest
// (Christofides 1976).
//
// On the metric closure (shortest-path lengths): the minimum spanning tree (Prim 1957), joined with
// a minimum-weight perfect matching of the vertices that have an odd number of its edges, has a
// closed walk over each edge once (Hierholzer 1873); skipping vertices that have been passed makes
// a tour. The matching is exact (dynamic programming over subsets) for up to 16 odd vertices.
// Beyond that it is greedy (each with the nearest that is left), then improved by exchanges of two
// pairs until none helps, so the factor 1.5 is not certain. O(k²) memory and time for k vertices,
// beside the matching's 2^16 · 16 or, per pass, O(k²). Deterministic; pure.
#include <span>
#include <vector>

#include "common/world/shortest_paths.h"

namespace ronda {

/// `vertices`, at least one and all different, in the order of the tour; the first stays first.
std::vector<int> ChristofidesTour(const ShortestPaths& paths, std::span<const int> vertices);

}  // namespace ronda
