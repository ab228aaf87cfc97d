#pragma once
// The observation of thesis §4.4.4: the agent-vertex matrix M, flattened, and the idleness of every
// vertex.
//
// O = (N + 1)·V: the rows of M (V numbers each), the deciding robot's first, the others' in index
// order; then the idleness by vertex as log1p(idleness / present mean), clipped to 8, the mean
// floored at 1e-6 of what this robot takes for the mean edge. A = V: action k goes to vertex k,
// legal where that is a neighbour of the robot's vertex, or staying put. The thesis reads M alone;
// with its own row first a robot knows which one it is, and with the idleness it can tell what to
// do.
//
// A row is 1 at the robot's vertex; on an edge of length l with d left to go it is 1 − d/l at the
// end ahead and d/l at the end behind (the thesis has 0.5 and 0.5 on all of the edge). d is the
// time until the announced arrival times the robot's speed, at most l: under travel noise a robot
// that is slow today stands at the end behind for a while. O(N·V) a call, no allocation.
// Thread-compatible.
#include <cstdint>
#include <span>

#include "common/environments/idleness_scale.h"
#include "common/world/belief.h"

namespace ronda {

/// The row of M (V) of any robot, as `belief` has it; 0 where nothing is known of it.
void WriteAffiliation(const Belief& belief, int robot, std::span<float> row);

class MatrixEncoder {
 public:
  /// `graph` must outlive it; `robots` = N ≥ 1 is the team of every world it will see; `stay`:
  /// staying put is an action where it is legal.
  MatrixEncoder(const PatrolGraph& graph, int robots, bool stay);

  int robots() const { return robots_; }
  int num_actions() const { return graph_->vertex_count(); }
  int observation_size() const { return (robots_ + 1) * num_actions(); }
  void Encode(const Belief& belief, std::span<float> observation,
              std::span<std::uint8_t> legal_actions);
  int NextVertex(int /*vertex*/, int action) const { return action; }

 private:
  const PatrolGraph* graph_;
  int robots_;
  bool stay_;
  ScaledIdleness idleness_;
};

}  // namespace ronda
