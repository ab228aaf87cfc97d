#pragma once
// Random maps to train and to test on: points spread over a square, joined by short edges that do
// not cross.
//
// Points are uniform but for a least distance of side / (2 √V) (simple sequential inhibition,
// Diggle 1983). Edges are the minimum spanning tree of the points and, until the wanted mean degree
// is reached, further edges of their Gabriel graph (Gabriel & Sokal 1969), drawn uniformly. The
// tree is part of the Gabriel graph, and that of the Delaunay triangulation (Toussaint 1980), so
// the graph is connected and planar: no two edges cross.
//
// Deterministic in the options on every machine: points lie on an integer grid, where all
// comparisons are exact. Pure functions; O(V²), 0.2 s at V = 10 000. Throw InputError.
#include <cstdint>
#include <optional>
#include <string>

#include "common/world/patrol_graph.h"

namespace ronda {

struct RandomGraphOptions {
  int vertices = 40;  // 2 … PatrolGraph::kMaxVertices
  std::uint64_t seed = 1;
  double degree = 2.5;        // mean, 2 … 4; at least a tree, at most the Gabriel graph
  double mean_edge_m = 10.0;  // 0.01 … 1e6
  std::string name = {};      // empty: "random:VERTICES:SEED"
};

/// Ids are 0 … V − 1; 1 m per px.
PatrolGraph RandomGeometricGraph(const RandomGraphOptions& options);

/// The options that a map's name `random:VERTICES:SEED` stands for; nullopt where a name does not
/// begin with `random:`.
std::optional<RandomGraphOptions> ParseRandomMap(const std::string& name);

}  // namespace ronda
