#pragma once
// When the rest of the team can be where: what the other robots announced, carried on along
// shortest paths.
//
// Everything here is in units of one length (chosen when the table is made): distances divided by
// it, times by what the observing robot needs for it, so observations depend on no speed. Rows are
// padded with zeros to a multiple of 8, so that loops over them need no remainder. O(V²) memory for
// the table. Immutable table; TeamArrivals is thread-compatible and allocates only when the team
// grows.
#include <cstddef>
#include <span>
#include <vector>

#include "common/world/belief.h"
#include "common/world/shortest_paths.h"

namespace ronda {

class DistanceTable {
 public:
  DistanceTable(const ShortestPaths& paths, double unit_m);

  const float* row(int vertex) const { return &distances_[offset(vertex)]; }
  float distance(int from, int to) const { return row(from)[to]; }
  std::size_t offset(int row) const { return static_cast<std::size_t>(row) * stride_; }
  std::size_t stride() const { return stride_; }  // V, rounded up
  double unit_m() const { return unit_m_; }

 private:
  double unit_m_;
  std::size_t stride_;
  std::vector<float> distances_;  // (V, stride), units
};

/// Another robot on its way: where to, when it will be there (from now), and how much longer than
/// the observing robot it takes for one unit.
struct OtherRobot {
  int target = 0;
  float remaining = 0.0f;  // units of time, ≥ 0
  float pace = 1.0f;       // observing robot's speed / this robot's speed
};

class TeamArrivals {
 public:
  /// `distances` must outlive it.
  explicit TeamArrivals(const DistanceTable* distances);

  /// What a robot knows of the others at this moment.
  void Observe(const Belief& belief);

  /// Those whose way is known, in index order.
  std::span<const OtherRobot> others() const { return others_; }
  /// (stride) the earliest time until another robot can be at each vertex: its arrival plus the
  /// distance on, at its own speed; ∞ where no other robot is known. In units of time.
  const float* earliest() const { return earliest_.data(); }

 private:
  const DistanceTable* distances_;
  std::vector<OtherRobot> others_;
  std::vector<float> earliest_;
};

}  // namespace ronda
