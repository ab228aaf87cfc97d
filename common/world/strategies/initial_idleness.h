#pragma once
// Idleness where a vertex that nobody has visited yet counts as idle since before the beginning, so
// that a team explores its map first.
//
// A vertex counts as visited if it is known to be so, or if a robot starts there (all know the
// starts, also those of robots that join later).
#include <cstdint>
#include <span>
#include <vector>

#include "common/world/belief.h"

namespace ronda {

class InitialIdleness {
 public:
  /// An episode whose robots start at `starts`; all else is idle since −`initial_s`.
  void Begin(const PatrolGraph& graph, std::span<const RobotStart> starts, double initial_s) {
    initial_s_ = initial_s;
    is_start_.assign(static_cast<std::size_t>(graph.vertex_count()), 0);
    for (const RobotStart& start : starts) is_start_[start.vertex] = 1;
  }

  double idleness_s(const Belief& belief, int vertex) const {
    const bool visited = is_start_[vertex] != 0 || belief.last_visit_s(vertex) > 0.0;
    return belief.idleness_s(vertex) +
           (visited ? 0.0 : belief.graph->weights()[vertex] * initial_s_);
  }

 private:
  double initial_s_ = 0.0;
  std::vector<std::uint8_t> is_start_;  // (V)
};

}  // namespace ronda
