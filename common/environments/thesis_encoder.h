#pragma once
// The observation of thesis §3.3: all vertices, nearest first, each with its distance and idleness;
// and, if wanted, when the nearest other robot can be there.
//
// O = 2 V or 3 V: distances from the robot's vertex, ascending (equals by index); idleness in that
// order; earliest arrivals of another robot in that order. A = V: action k goes to the k-th vertex
// of the order, legal where that is a neighbour; action 0, staying put, where that is. Scales:
// distances by the mean over all ordered pairs of different vertices, clipped to 8; idleness as
// idleness_scale.h says, its mean floored at 1e-6 of what this robot takes for the mean distance;
// arrivals by that time, clipped to 8 (no other robot: 8). So the observation depends on no speed.
// The third block is not in the thesis: without it robots can't tell where others go, and flock.
// O(V) a call, O(N·V) with the third block, O(V log V) with ranks; no allocation once warm; O(V²)
// memory, shared by copies. Thread-compatible.
#include <cstdint>
#include <memory>
#include <span>

#include "common/environments/idleness_scale.h"
#include "common/environments/team_arrivals.h"
#include "common/world/belief.h"
#include "common/world/shortest_paths.h"

namespace ronda {

/// What stands in the vector beside the distances.
struct ThesisBlocks {
  IdlenessScale idleness = IdlenessScale::kRelative;
  double alpha = 0.0;   // of the idleness, as ScaledIdleness
  bool others = false;  // the third block
  bool stay = false;    // staying put is an action where it is legal
};

class ThesisEncoder {
 public:
  /// `graph` must outlive it; `paths` are the graph's.
  ThesisEncoder(const PatrolGraph& graph, const ShortestPaths& paths, const ThesisBlocks& blocks);

  int num_actions() const { return graph_->vertex_count(); }
  int observation_size() const { return (blocks_.others ? 3 : 2) * num_actions(); }
  void Encode(const Belief& belief, std::span<float> observation,
              std::span<std::uint8_t> legal_actions);
  int NextVertex(int vertex, int action) const;

 private:
  struct Tables;
  const PatrolGraph* graph_;
  ThesisBlocks blocks_;
  std::shared_ptr<const Tables> tables_;
  ScaledIdleness idleness_;
  TeamArrivals team_;
};

}  // namespace ronda
