#include "common/world/shortest_paths.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace ronda {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Dijkstra (1959) with a binary heap. Writes the distances to `root` into `distances_m`, (V), all
/// infinite before; returns each vertex's place in the order in which they became final.
std::vector<int> DistancesTo(const PatrolGraph& graph, int root, double* distances_m) {
  using Entry = std::pair<double, int>;  // (distance, vertex)
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<int> order(graph.vertex_count(), -1);
  int settled = 0;
  distances_m[root] = 0.0;
  open.emplace(0.0, root);
  while (!open.empty()) {
    const auto [distance_m, vertex] = open.top();
    open.pop();
    if (order[vertex] >= 0) continue;  // stale
    order[vertex] = settled++;
    const auto neighbours = graph.neighbours(vertex);
    const auto lengths_m = graph.lengths_m(vertex);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const double reached_m = distance_m + lengths_m[k];
      if (reached_m < distances_m[neighbours[k]]) {
        distances_m[neighbours[k]] = reached_m;
        open.emplace(reached_m, neighbours[k]);
      }
    }
  }
  return order;
}

/// The first neighbour of `from` on a path to the root that is shortest up to rounding. Only
/// neighbours that were final earlier count, so every sequence of hops ends, whatever the rounding.
int NextHop(const PatrolGraph& graph, int from, const double* distances_m,
            const std::vector<int>& order) {
  constexpr double kTieTolerance = 1e-9;  // relative: sums in another order differ by less
  int best = from;                        // the root itself
  double best_m = kInfinity;
  const auto neighbours = graph.neighbours(from);
  const auto lengths_m = graph.lengths_m(from);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const int neighbour = neighbours[k];
    const double through_m = lengths_m[k] + distances_m[neighbour];
    if (order[neighbour] < order[from] && through_m < best_m - kTieTolerance * distances_m[from]) {
      best = neighbour;
      best_m = through_m;
    }
  }
  return best;
}

}  // namespace

ShortestPaths::ShortestPaths(const PatrolGraph& graph)
    : vertex_count_(graph.vertex_count()),
      distances_m_(static_cast<std::size_t>(vertex_count_) * vertex_count_, kInfinity),
      next_hop_(distances_m_.size(), 0) {
  for (int root = 0; root < vertex_count_; ++root) {
    double* const row_m = &distances_m_[root * vertex_count_];
    const std::vector<int> order = DistancesTo(graph, root, row_m);
    for (int from = 0; from < vertex_count_; ++from) {
      next_hop_[from * vertex_count_ + root] = NextHop(graph, from, row_m, order);
    }
    // Both directions the same to the last bit: the sums run in opposite orders.
    for (int other = 0; other < root; ++other) {
      row_m[other] = distances_m_[other * vertex_count_ + root];
    }
  }
}

}  // namespace ronda
