#include "common/environments/sorted_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ronda {
namespace {

float Scaled(double ratio) { return static_cast<float>(std::min(8.0, std::log1p(ratio))); }

}  // namespace

SortedVertices::SortedVertices(const PatrolGraph& graph, const ShortestPaths& paths)
    : graph_(graph),
      paths_(paths),
      vertex_count_(graph.vertex_count()),
      order_(static_cast<std::size_t>(vertex_count_) * vertex_count_) {
  for (int u = 0; u < vertex_count_; ++u) {
    const auto row = order_.begin() + static_cast<std::ptrdiff_t>(u) * vertex_count_;
    std::iota(row, row + vertex_count_, 0);
    std::stable_sort(row, row + vertex_count_,
                     [&](int a, int b) { return paths.distance_m(u, a) < paths.distance_m(u, b); });
  }
}

void SortedVertices::Encode(const PatrolWorld& world, int robot, std::span<float> out,
                            std::span<std::uint8_t> legal) const {
  const int u = world.target(robot);
  const auto count = static_cast<std::size_t>(vertex_count_);
  const double mean_edge_m = graph_.mean_edge_length_m();
  const double mean_edge_s = mean_edge_m / world.speed_mps(robot);
  const double mean_idleness_s = std::max(1e-6, world.instantaneous_graph_idleness_s());
  const auto neighbours = graph_.neighbours(u);
  for (std::size_t k = 0; k < count; ++k) {
    const int x = NextVertex(u, static_cast<int>(k));
    double others_s = std::numeric_limits<double>::infinity();
    for (int other = 0; other < world.robot_count(); ++other) {
      if (other == robot) continue;
      others_s = std::min(others_s,
                          world.arrival_s(other) - world.time_s() +
                              paths_.distance_m(world.target(other), x) / world.speed_mps(other));
    }
    out[k] = Scaled(paths_.distance_m(u, x) / mean_edge_m);
    out[count + k] = Scaled(world.idleness_s(x) / mean_idleness_s);
    out[2 * count + k] = Scaled(others_s / mean_edge_s);
    legal[k] = std::binary_search(neighbours.begin(), neighbours.end(), x) ? 1 : 0;
  }
}

}  // namespace ronda
