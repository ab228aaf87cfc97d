#pragma once
// Lower bounds on the average graph idleness, from rates of traversal alone.
//
// A vertex of weight w that is visited at a rate f, and at which a robot stands for a share π of
// the time, has a weighted idleness of at least w (1 − π)² / (2 f); half the rates of the edges at
// a vertex are its visits. The bounds minimise the mean of that over all rates x and shares π that
// the robots can afford, by multiplicative updates of l_e x_e. What is returned is a certificate of
// the dual, which holds after any number of updates; it stops within 1e-6 of the value. Pure
// functions; an update is O(V + E), with parking O(V log V); below a second at V = 1000. Source:
// docs/bounds.md.
#include <span>

#include "common/world/patrol_graph.h"

namespace ronda {

inline constexpr int kMaxFluidUpdates = 20000;

/// Robots that keep moving, times the sum of their speeds: AGI ≥ this / Σ speeds.
double FluidBound_m(const PatrolGraph& graph, int max_updates = kMaxFluidUpdates);

/// The same without a search, hence a little weaker: (Σ_v √(w_v m_v))² / (2V), m_v the shortest
/// edge at v.
double ClosedFormBound_m(const PatrolGraph& graph);

/// Robots that may also stand still at vertices, which the slowest lose least by. No more than the
/// bound of robots that keep moving; 0 where there is a robot for each vertex.
double ParkingBound_s(const PatrolGraph& graph, std::span<const double> speeds_mps,
                      int max_updates = kMaxFluidUpdates);

}  // namespace ronda
