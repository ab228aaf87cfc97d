#include "common/world/closed_walk_bound.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "common/world/covering_bound.h"

namespace ronda {
namespace {

/// A spanning tree of the vertices from 1 on, and two edges at vertex 0.
struct OneTree {
  double cost_m = 0.0;
  std::vector<int> degrees;  // (V)
};

/// The cheapest, where the edge between u and v costs distance + multiplier_u + multiplier_v. Prim.
OneTree MinimumOneTree(const ShortestPaths& paths, const std::vector<double>& multipliers_m) {
  const int count = paths.vertex_count();
  OneTree tree{.degrees = std::vector<int>(count, 0)};
  const auto join = [&](int a, int b, double cost_m) {
    tree.cost_m += cost_m;
    ++tree.degrees[a];
    ++tree.degrees[b];
  };
  std::vector<double> cost_m(count, std::numeric_limits<double>::infinity());  // to join the tree
  std::vector<int> parent(count, -1);
  std::vector<int> outside(count - 1);
  for (int v = 1; v < count; ++v) outside[v - 1] = v;
  while (!outside.empty()) {
    const auto nearest = std::min_element(outside.begin(), outside.end(),
                                          [&](int a, int b) { return cost_m[a] < cost_m[b]; });
    const int added = *nearest;
    *nearest = outside.back();
    outside.pop_back();
    if (parent[added] >= 0) join(added, parent[added], cost_m[added]);
    const double* const distances_m = paths.distances_from(added);
    for (const int v : outside) {
      const double through_m = distances_m[v] + multipliers_m[added] + multipliers_m[v];
      if (through_m < cost_m[v]) {
        cost_m[v] = through_m;
        parent[v] = added;
      }
    }
  }
  std::pair<double, int> first{std::numeric_limits<double>::infinity(), 0};
  std::pair<double, int> second = first;
  for (int v = 1; v < count; ++v) {
    const std::pair edge{paths.distance_m(0, v) + multipliers_m[0] + multipliers_m[v], v};
    second = std::min(second, std::max(first, edge));
    first = std::min(first, edge);
  }
  join(0, first.second, first.first);
  join(0, second.second, second.first);
  return tree;
}

}  // namespace

double OneTreeBound_m(const ShortestPaths& paths, int iterations) {
  constexpr double kMemory = 0.3;  // of the last direction
  const int count = paths.vertex_count();
  if (count < 3) return 0.0;
  std::vector<double> multipliers_m(count, 0.0);
  std::vector<double> last(count, 0.0);
  double best_m = 0.0;
  double first_step_m = 0.0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const OneTree tree = MinimumOneTree(paths, multipliers_m);
    // A tour is a 1-tree in which every vertex has two edges, so the multipliers cost it 2 Σ.
    double certified_m = tree.cost_m;
    for (const double multiplier_m : multipliers_m) certified_m -= 2.0 * multiplier_m;
    best_m = std::max(best_m, certified_m);
    if (iteration == 0) first_step_m = certified_m / (2.0 * count);
    const double left = 1.0 - static_cast<double>(iteration) / iterations;
    bool tour = true;
    for (int v = 0; v < count; ++v) {
      const double excess = tree.degrees[v] - 2;
      tour = tour && excess == 0.0;
      multipliers_m[v] +=
          first_step_m * left * left * ((1.0 - kMemory) * excess + kMemory * last[v]);
      last[v] = excess;
    }
    if (tour) break;  // the shortest
  }
  return best_m;
}

ClosedWalkBound ClosedWalkLowerBound(const PatrolGraph& graph, const ShortestPaths& paths) {
  constexpr double kEffort = 1e8;  // iterations · V²
  const double count = graph.vertex_count();
  const int iterations = static_cast<int>(std::clamp(kEffort / (count * count), 10.0, 5000.0));
  const double trees_m = OneTreeBound_m(paths, iterations);
  // A closed walk visits every vertex, whatever its priority.
  const std::vector<double> duals_m = CoveringDuals_m(graph);
  const double covering_m = 2.0 * std::accumulate(duals_m.begin(), duals_m.end(), 0.0);
  if (trees_m > covering_m) return {.length_m = trees_m, .method = "1-trees (Held and Karp)"};
  return {.length_m = covering_m, .method = "covering linear programme"};
}

}  // namespace ronda
