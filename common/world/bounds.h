#pragma once
// Lower bounds on what any team can reach on a graph, printed beside every result.
//
// They hold for unlimited time and for robots that each move along edges at a speed of their own;
// `staying` says whether they may also stand still at a vertex. Idleness counts by the graph's
// weights: AGI is the mean of w_v I_v, WI the largest. Every value is a certificate: however early
// or badly an optimiser stopped, it is a bound. Of robots that keep moving only the sum of the
// speeds counts; of those that may stand, the bounds let the slowest do so.
//
// Throws InputError when there is no robot, or when a speed is not positive and finite. Pure
// functions. A few milliseconds for the shipped maps, about a second at V = 1000, from where it
// grows with V² where there are priorities or one robot. Source: docs/bounds.md.
#include <string>
#include <vector>

#include "common/world/patrol_graph.h"
#include "common/world/shortest_paths.h"

namespace ronda {

struct BoundsOptions {
  std::vector<double> speeds_mps;  // (N), each > 0
  bool staying = false;            // a robot may stand at a vertex, whose idleness is then 0
};

struct LowerBounds {
  double agi_s = 0.0;           // average graph idleness
  std::string agi_method = {};  // what gave agi_s
  double wi_s = 0.0;            // worst idleness
  std::string wi_method = {};
};

/// `paths` are those of `graph`.
LowerBounds ComputeLowerBounds(const PatrolGraph& graph, const ShortestPaths& paths,
                               const BoundsOptions& options);

}  // namespace ronda
