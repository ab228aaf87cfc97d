#include "common/world/spanning_forest.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ronda {
namespace {

/// Kruskal: the edges of a minimum spanning tree of what `edges` join, ascending by length.
std::vector<Edge> MinimumSpanningTree(std::vector<Edge> edges, int vertices) {
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.length_m < b.length_m; });
  std::vector<int> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<Edge> tree;
  for (const Edge& edge : edges) {
    const int source = root(edge.source);
    const int target = root(edge.target);
    if (source == target) continue;
    parent[source] = target;
    tree.push_back(edge);
  }
  return tree;
}

/// The tree without its N − 1 longest edges.
double ForestLength_m(const std::vector<Edge>& tree, int robots) {
  double length_m = 0.0;
  for (std::size_t k = 0; k + robots <= tree.size(); ++k) length_m += tree[k].length_m;
  return length_m;
}

}  // namespace

double SpanningForestBound_m(const PatrolGraph& graph, const ShortestPaths& paths, int robots) {
  const int count = graph.vertex_count();
  if (graph.unweighted()) return ForestLength_m(MinimumSpanningTree(graph.edges(), count), robots);
  // The heaviest vertices first: each set down to some weight needs its own forest. A vertex more
  // changes a tree by its own edges at most.
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return graph.weights()[a] > graph.weights()[b]; });
  std::vector<Edge> tree;
  double best_m = 0.0;
  for (int k = 1; k < count; ++k) {
    for (int other = 0; other < k; ++other) {
      tree.push_back({order[k], order[other], paths.distance_m(order[k], order[other])});
    }
    tree = MinimumSpanningTree(std::move(tree), count);
    best_m = std::max(best_m, graph.weights()[order[k]] * ForestLength_m(tree, robots));
  }
  return best_m;
}

}  // namespace ronda
