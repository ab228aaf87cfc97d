#pragma once
// The thesis's asynchronous observation (§3.3) with the others' arrival times: three numbers for
// each vertex, nearest first.
//
// For vertices in ascending order of distance from the robot's vertex (ties by index):
// log1p(distance / ℓ) (V), then log1p(idleness / m) (V), then log1p(time until another robot can be
// there / ℓ) (V), ℓ the mean edge length (as a time at the robot's speed), m the mean idleness;
// clipped to 8. Action k goes to the k-th vertex of that order, legal where it is a neighbour.
// Immutable; Encode allocates nothing and costs O(N · V). Thread-safe.
#include <cstdint>
#include <span>
#include <vector>

#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"

namespace ronda {

class SortedVertices {
 public:
  SortedVertices(const PatrolGraph& graph, const ShortestPaths& paths);

  void Encode(const PatrolWorld& world, int robot, std::span<float> out,
              std::span<std::uint8_t> legal) const;
  int NextVertex(int vertex, int action) const { return order_[vertex * vertex_count_ + action]; }

 private:
  const PatrolGraph& graph_;
  const ShortestPaths& paths_;
  int vertex_count_;
  std::vector<int> order_;  // (V, V)
};

}  // namespace ronda
