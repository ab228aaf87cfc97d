#pragma once
// All-pairs shortest paths of a patrol graph (Dijkstra from every vertex). O(V·E log V) time, O(V²)
// memory. Immutable; any number of threads may read.
#include <vector>

#include "common/world/patrol_graph.h"

namespace ronda {

class ShortestPaths {
 public:
  explicit ShortestPaths(const PatrolGraph& graph);

  double distance_m(int from, int to) const { return distances_m_[from * vertex_count_ + to]; }
  /// The row of distances from one vertex, (V).
  const double* distances_from(int from) const { return &distances_m_[from * vertex_count_]; }
  /// The neighbour of `from` that a shortest path to `to` takes next (lowest index among equals);
  /// `to` itself if equal.
  int next_hop(int from, int to) const { return next_hop_[from * vertex_count_ + to]; }
  int vertex_count() const { return vertex_count_; }

 private:
  int vertex_count_;
  std::vector<double> distances_m_;  // (V, V)
  std::vector<int> next_hop_;        // (V, V)
};

}  // namespace ronda
