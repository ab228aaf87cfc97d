#pragma once
// The observation of the shared scorer: 26 numbers for each neighbour that a robot may go to,
// independent of the map's size.
//
// For the robot that has arrived at u: with w the way to candidate v, d the way from v on, times at
// the robot's own speed, m the mean idleness, ℓ the mean edge length (as a time), e(x) idleness (0
// for u and for what another robot heads to), eta(x) the earliest time until another robot can be
// at x, own = {x : w + d(v, x) < eta(x)}, behind = {x ≠ u : v is on a shortest path from u to x}.
// Values are clipped to ± 8. Same features when all speeds are scaled and times shrink accordingly.
// Immutable tables (V·V), made once for each map; Encode allocates nothing and costs about
// O(candidates · V + N · V). Thread-safe but for the scratch that the caller passes.
#include <span>
#include <vector>

#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"

namespace ronda {

class CandidateFeatures {
 public:
  static constexpr int kFeatures = 26;

  struct Scratch {
    std::vector<float> idleness_s;    // (V) e
    std::vector<float> others_s;      // (V) eta
    std::vector<float> crowding;      // (candidates)
    std::vector<float> behind_sum_s;  // (candidates)
  };

  CandidateFeatures(const PatrolGraph& graph, const ShortestPaths& paths);

  /// `out` gets degree(u) rows of kFeatures, in the order of graph.neighbours(u).
  void Encode(const PatrolWorld& world, int robot, Scratch& scratch, std::span<float> out) const;

 private:
  struct Team;  // what is the same for all candidates of one decision
  void EncodeCandidate(const PatrolWorld& world, const Team& team, int k, Scratch& scratch,
                       float* row) const;

  const PatrolGraph& graph_;
  int vertex_count_;
  float mean_edge_m_;
  std::vector<float> distances_m_;  // (V, V)
  std::vector<float>
      kernels_;  // (V, 3, V) exp(−d/ℓ), exp(−d/3ℓ), exp(−d/9ℓ), each row summing to 1
  std::vector<float> behind_;  // (2E, V) 1 where x is behind the arc
};

}  // namespace ronda
