#pragma once
// Lower bounds on the worst idleness from how often each vertex must be visited: the covering
// linear programme.
//
// For a worst weighted idleness of W a vertex of weight w needs a visit in every W / w seconds. Row
// duals y of min Σ l_e x_e subject to ½ Σ_{e at v} x_e ≥ w_v come from GLPK, whose dual simplex may
// stop anywhere: they are made feasible (y_u + y_v ≤ l_uv, y ≥ 0), and any such y proves a bound.
// Pure functions; a few tens of milliseconds at V = 1000. Source: docs/bounds.md.
#include <span>
#include <vector>

#include "common/world/patrol_graph.h"

namespace ronda {

/// Robots that keep moving, times the sum of their speeds: WI ≥ this / Σ speeds.
double CoveringBound_m(const PatrolGraph& graph);

/// Robots that may also stand still at vertices, which the slowest lose least by. 0 where there is
/// a robot for each vertex.
double ParkedCoveringBound_s(const PatrolGraph& graph, std::span<const double> speeds_mps);

/// The parts. Feasible duals as good as the solver made them, (V); a closed walk through all
/// vertices is no shorter than twice their sum.
std::vector<double> CoveringDuals_m(const PatrolGraph& graph);
/// Feasible ones near the ones given; what is not finite counts as 0.
std::vector<double> FeasibleCoveringDuals_m(const PatrolGraph& graph, std::vector<double> duals_m);
/// What feasible duals prove.
double CoveringBoundOf_m(const PatrolGraph& graph, std::span<const double> duals_m);
double ParkedCoveringBoundOf_s(const PatrolGraph& graph, std::span<const double> speeds_mps,
                               std::span<const double> duals_m);

}  // namespace ronda
