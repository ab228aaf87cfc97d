#pragma once
// The 26 features of candidate_encoder.h again, in double and with no table but the distances:
// plain loops, one feature after the other, for tests to compare with and benchmarks to time
// against.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"

namespace ronda {

/// Row k of the observation of `robot`, (26), for each neighbour k of where it stands.
inline std::vector<std::vector<double>> ReferenceCandidateFeatures(const PatrolWorld& world,
                                                                   const ShortestPaths& paths,
                                                                   int robot) {
  const PatrolGraph& graph = world.graph();
  const int vertices = graph.vertex_count();
  const int robots = world.robot_count();
  const int u = world.target(robot);
  const double unit_m = graph.mean_edge_length_m();
  const double unit_s = unit_m / world.speed_mps(robot);
  const double slack = 1e-5;
  const auto d = [&](int a, int b) { return paths.distance_m(a, b) / unit_m; };
  const auto idleness = [&](int x) { return world.idleness_s(x) / unit_s; };
  const auto remaining = [&](int k) {  // as announced: without the noise
    return std::max(0.0, world.expected_arrivals_s()[k] - world.time_s()) / unit_s;
  };
  const auto can_be_at = [&](int k, int x) {
    return remaining(k) + d(world.target(k), x) * world.speed_mps(robot) / world.speed_mps(k);
  };
  const auto claimed = [&](int x) {
    for (int k = 0; k < robots; ++k) {
      if (k != robot && world.target(k) == x) return true;
    }
    return false;
  };

  double m = 0.0;
  double largest_e = 1e-6;
  std::vector<double> e(vertices);
  std::vector<double> eta(vertices, std::numeric_limits<double>::infinity());
  for (int x = 0; x < vertices; ++x) {
    m += idleness(x) / vertices;
    e[x] = x == u || claimed(x) ? 0.0 : idleness(x);
    largest_e = std::max(largest_e, e[x]);
    for (int k = 0; k < robots; ++k) {
      if (k != robot) eta[x] = std::min(eta[x], can_be_at(k, x));
    }
  }
  m = std::max(m, 1e-6);

  std::vector<std::vector<double>> rows;
  double sum_over_candidates = 0.0;
  for (int k = 0; k < graph.degree(u); ++k) {
    const int v = graph.neighbours(u)[k];
    const double w = graph.lengths_m(u)[k] / unit_m;
    const auto is_own = [&](int x) { return w + d(v, x) + slack < eta[x]; };
    const auto is_behind = [&](int x) { return x != u && d(u, x) >= w + d(v, x) - slack; };
    const auto kernel_mean = [&](double reach, bool own_only) {
      double sum = 0.0;
      double weights = 0.0;
      for (int x = 0; x < vertices; ++x) {
        const double weight = std::exp(-d(v, x) / reach);
        weights += weight;
        if (!own_only || is_own(x)) sum += weight * e[x];
      }
      return sum / weights / m;
    };
    const auto best_rate = [&](bool own_only) {
      double best = 0.0;
      for (int x = 0; x < vertices; ++x) {
        if (!is_behind(x) || e[x] <= 0.0 || (own_only && !is_own(x))) continue;
        const double t = w + d(v, x);
        best = std::max(best, (e[x] + t) / (t + 0.3) / m);
      }
      return std::log1p(best);
    };
    double on_arrival = idleness(v) + w;
    double crowding = 0.0;
    for (int other = 0; other < robots; ++other) {
      if (other == robot) continue;
      crowding += std::exp(-can_be_at(other, v) / 2.0);
      if (world.target(other) == v && remaining(other) <= w + slack) {
        on_arrival = std::min(on_arrival, std::max(0.0, w - remaining(other)));
      }
    }
    double count = 0.0;
    double sum = 0.0;
    double largest = 0.0;
    for (int x = 0; x < vertices; ++x) {
      if (!is_behind(x) || !is_own(x)) continue;
      count += 1.0;
      sum += e[x];
      largest = std::max(largest, e[x]);
    }
    sum_over_candidates += sum;
    const double lead = std::clamp(eta[v] - w, -4.0, 4.0) / 2.0;
    const double is_claimed = claimed(v) ? 1.0 : 0.0;
    rows.push_back({w,
                    idleness(v) / m,
                    on_arrival / m,
                    is_claimed,
                    std::log1p(on_arrival / m) - std::log(w + 0.1),
                    lead,
                    crowding,
                    graph.degree(v) / 3.0,
                    world.previous_vertex(robot) == v ? 1.0 : 0.0,
                    kernel_mean(1.0, false),
                    kernel_mean(3.0, false),
                    kernel_mean(9.0, false),
                    kernel_mean(1.0, true),
                    kernel_mean(3.0, true),
                    kernel_mean(9.0, true),
                    best_rate(false),
                    best_rate(true),
                    count * robots / vertices,
                    idleness(v) / largest_e,
                    is_claimed * lead,
                    count > 0.0 ? sum / count / m : 0.0,
                    sum,
                    4.0 * robots / vertices,
                    graph.degree(u) / 3.0,
                    largest / largest_e,
                    std::log(m * robots / vertices + 0.001)});
  }
  for (auto& row : rows) {
    row[21] /= std::max(1e-6, sum_over_candidates);
    for (double& feature : row) feature = std::clamp(feature, -8.0, 8.0);
  }
  return rows;
}

}  // namespace ronda
