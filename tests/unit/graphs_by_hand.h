#pragma once
// Small graphs whose episodes can be traced by hand.
#include <string>
#include <vector>

#include "common/world/patrol_world.h"

namespace ronda::testing {

/// Vertices named 0, 1, …, all on one point: only the edges' lengths matter.
inline PatrolGraph GraphOf(int vertices, std::vector<Edge> edges) {
  GraphData data;
  data.name = "by hand";
  for (int v = 0; v < vertices; ++v) data.vertex_ids.push_back(std::to_string(v));
  data.positions.resize(static_cast<std::size_t>(vertices));
  data.edges = std::move(edges);
  return PatrolGraph(std::move(data));
}

/// 0 –2 m– 1 –3 m– 2
inline PatrolGraph Path() { return GraphOf(3, {{0, 1, 2.0}, {1, 2, 3.0}}); }

/// 0 in the middle, 1 … leaves around it, each 1 m away.
inline PatrolGraph Star(int leaves) {
  std::vector<Edge> edges;
  for (int leaf = 1; leaf <= leaves; ++leaf) edges.push_back({0, leaf, 1.0});
  return GraphOf(leaves + 1, edges);
}

/// Robots standing on these vertices.
inline std::vector<RobotStart> StandingOn(const std::vector<int>& vertices) {
  std::vector<RobotStart> starts;
  for (const int vertex : vertices) starts.push_back({.vertex = vertex, .next = vertex});
  return starts;
}

}  // namespace ronda::testing
