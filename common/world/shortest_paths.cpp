#include "common/world/shortest_paths.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace ronda {
namespace {

/// Distances from `source` to all vertices, written to `distances_m` (V).
void Dijkstra(const PatrolGraph& graph, int source, double* distances_m) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distances_m[source] = 0.0;
  open.emplace(0.0, source);
  while (!open.empty()) {
    const auto [distance_m, vertex] = open.top();
    open.pop();
    if (distance_m > distances_m[vertex]) continue;
    const auto neighbours = graph.neighbours(vertex);
    const auto lengths_m = graph.lengths_m(vertex);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const double through_m = distance_m + lengths_m[k];
      if (through_m < distances_m[neighbours[k]]) {
        distances_m[neighbours[k]] = through_m;
        open.emplace(through_m, neighbours[k]);
      }
    }
  }
}

}  // namespace

ShortestPaths::ShortestPaths(const PatrolGraph& graph)
    : vertex_count_(graph.vertex_count()),
      distances_m_(static_cast<std::size_t>(vertex_count_) * vertex_count_,
                   std::numeric_limits<double>::infinity()),
      next_hop_(distances_m_.size()) {
  for (int v = 0; v < vertex_count_; ++v) Dijkstra(graph, v, &distances_m_[v * vertex_count_]);
  for (int from = 0; from < vertex_count_; ++from) {
    const auto neighbours = graph.neighbours(from);
    const auto lengths_m = graph.lengths_m(from);
    for (int to = 0; to < vertex_count_; ++to) {
      int best = from;
      double best_m = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; from != to && k < neighbours.size(); ++k) {
        const double through_m = lengths_m[k] + distance_m(neighbours[k], to);
        if (through_m < best_m) {
          best_m = through_m;
          best = neighbours[k];
        }
      }
      next_hop_[from * vertex_count_ + to] = best;
    }
  }
}

}  // namespace ronda
