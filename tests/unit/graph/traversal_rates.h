#pragma once
// Random ways to spend a team's time: what lower bounds are held against.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "common/base/rng.h"
#include "common/world/patrol_graph.h"

namespace ronda::testing {

/// What robots do in the long run.
struct TimeShares {
  std::vector<double> visits;  // (V) rate of visits, 1/s
  std::vector<double> parked;  // (V) share of the time in which a robot stands there
};

/// Robots of these speeds that each stand at one vertex for a share of their time in
/// 0 … `most_parked`, and drive the rest, which is spent on edges at random.
inline TimeShares RandomTimeShares(const PatrolGraph& graph, const std::vector<double>& speeds_mps,
                                   double most_parked, Rng& rng) {
  TimeShares shares{.visits = std::vector<double>(graph.vertex_count(), 0.0),
                    .parked = std::vector<double>(graph.vertex_count(), 0.0)};
  double driven_mps = 0.0;
  for (const double speed_mps : speeds_mps) {
    double& parked = shares.parked[rng.Below(graph.vertex_count())];
    const double share = std::min(1.0 - parked, most_parked * rng.Uniform());
    parked += share;
    driven_mps += speed_mps * (1.0 - share);
  }
  std::vector<double> rates(graph.edge_count());
  double length_mps = 0.0;
  for (int e = 0; e < graph.edge_count(); ++e) {
    rates[e] = std::exp(2.0 * rng.Normal());
    length_mps += rates[e] * graph.edges()[e].length_m;
  }
  for (int e = 0; e < graph.edge_count(); ++e) {
    const double half = 0.5 * rates[e] * driven_mps / length_mps;
    shares.visits[graph.edges()[e].source] += half;
    shares.visits[graph.edges()[e].target] += half;
  }
  return shares;
}

/// The least AGI with such shares: visits evenly spaced in the time that is left.
inline double LeastAgi_s(const PatrolGraph& graph, const TimeShares& shares) {
  double sum_s = 0.0;
  for (int v = 0; v < graph.vertex_count(); ++v) {
    const double alone = 1.0 - shares.parked[v];
    sum_s += graph.weights()[v] * alone * alone / (2.0 * shares.visits[v]);
  }
  return sum_s / graph.vertex_count();
}

/// The least WI with such shares.
inline double LeastWi_s(const PatrolGraph& graph, const TimeShares& shares) {
  double worst_s = 0.0;
  for (int v = 0; v < graph.vertex_count(); ++v) {
    worst_s = std::max(worst_s, graph.weights()[v] * (1.0 - shares.parked[v]) / shares.visits[v]);
  }
  return worst_s;
}

/// The graph with priorities from 1/8 to 8, at random.
inline PatrolGraph WithRandomPriorities(GraphData data, Rng& rng) {
  data.priorities.resize(data.positions.size());
  for (double& priority : data.priorities) priority = std::exp2(6.0 * rng.Uniform() - 3.0);
  return PatrolGraph(std::move(data));
}

}  // namespace ronda::testing
