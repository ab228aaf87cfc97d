#pragma once
// Lower bounds on what any team can reach on a graph, printed beside every result.
//
// They hold for unlimited time, for robots that keep moving along edges at their own speeds, of
// which only the sum counts. Both are certificates, evaluated from a feasible dual point: however
// early or badly an optimiser stopped, the value printed is a bound. Throws InputError when the
// total speed is not positive and finite or there is no robot. Pure functions; about a second at
// V = 1000. Source: docs/maps.md; relaxations of the patrolling problem by traversal rates.
#include <string>

#include "common/world/patrol_graph.h"

namespace ronda {

struct LowerBounds {
  double agi_s = 0.0;     // average graph idleness
  double wi_s = 0.0;      // worst idleness
  std::string wi_method;  // what gave wi_s
};

LowerBounds ComputeLowerBounds(const PatrolGraph& graph, double total_speed_mps, int robots);

/// The parts, each times a total speed of 1 m/s, hence in metres.
/// Least mean idleness over traversal rates x with Σ l_e x_e ≤ 1.
double FluidBound_m(const PatrolGraph& graph);
/// Least Σ l_e x_e under which each vertex is visited at a rate of at least 1.
double CoveringBound_m(const PatrolGraph& graph);
/// The minimum spanning tree without its N − 1 longest edges: N walks that cover V are no shorter.
double SpanningForestBound_m(const PatrolGraph& graph, int robots);

}  // namespace ronda
