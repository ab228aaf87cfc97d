#include "common/world/fluid_bound.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace ronda {
namespace {

constexpr double kGap = 1e-6;  // relative, between a value and its certificate

/// Rates of traversal x with Σ l_e x_e = 1, and what pulls at them.
class TraversalRates {
 public:
  explicit TraversalRates(const PatrolGraph& graph)
      : graph_(graph), share_(graph.edge_count(), 1.0 / graph.edge_count()) {}

  /// Σ x_e over the edges at each vertex, twice its rate of visits, (V) 1/m.
  std::vector<double> AtVertices() const {
    std::vector<double> sums(graph_.vertex_count(), 0.0);
    for (int e = 0; e < graph_.edge_count(); ++e) {
      const Edge& edge = graph_.edges()[e];
      const double rate = share_[e] / edge.length_m;
      sums[edge.source] += rate;
      sums[edge.target] += rate;
    }
    return sums;
  }

  /// What a metre on each edge gains, (E): (pull_u + pull_v) / (V l_e).
  std::vector<double> Slopes(const std::vector<double>& pull) const {
    std::vector<double> slopes(graph_.edge_count());
    for (int e = 0; e < graph_.edge_count(); ++e) {
      const Edge& edge = graph_.edges()[e];
      slopes[e] = (pull[edge.source] + pull[edge.target]) / (graph_.vertex_count() * edge.length_m);
    }
    return slopes;
  }

  /// Multiplies each l_e x_e by the root of its slope.
  void Update(const std::vector<double>& slopes) {
    constexpr double kLeast = 1e-100;  // an edge that nobody takes: small, and its inverse finite
    for (int e = 0; e < graph_.edge_count(); ++e) {
      share_[e] = std::max(kLeast, share_[e] * std::sqrt(slopes[e]));
    }
    const double total = std::accumulate(share_.begin(), share_.end(), 0.0);
    for (double& part : share_) part /= total;
  }

 private:
  const PatrolGraph& graph_;
  std::vector<double> share_;  // (E) l_e x_e
};

/// Robots of given speeds that share their time between moving and standing.
class Team {
 public:
  explicit Team(std::span<const double> speeds_mps)
      : speeds_mps_(speeds_mps.begin(), speeds_mps.end()) {
    std::sort(speeds_mps_.begin(), speeds_mps_.end());
  }

  int robots() const { return static_cast<int>(speeds_mps_.size()); }
  double total_mps() const { return std::accumulate(speeds_mps_.begin(), speeds_mps_.end(), 0.0); }

  /// The speed that is left when `parked` < N robots stand, the slowest first.
  double Moving_mps(double parked) const {
    const auto whole = static_cast<std::size_t>(parked);
    return std::accumulate(speeds_mps_.begin() + static_cast<std::ptrdiff_t>(whole),
                           speeds_mps_.end(), 0.0) -
           (parked - static_cast<double>(whole)) * speeds_mps_[whole];
  }
  /// What standing a little more takes of it.
  double Next_mps(double parked) const { return speeds_mps_[static_cast<std::size_t>(parked)]; }

  /// The most that shares of parking can gain, `gains` being those of whole vertices (V) and
  /// `per_m` that of a metre driven instead: the slowest robot takes the best vertex, and so on.
  double ParkingGain(std::vector<double> gains, double per_m) const {
    const auto places = std::min(gains.size(), speeds_mps_.size());
    std::partial_sort(gains.begin(), gains.begin() + static_cast<std::ptrdiff_t>(places),
                      gains.end(), std::greater<>());
    double gain = 0.0;
    for (std::size_t k = 0; k < places; ++k)
      gain += std::max(0.0, gains[k] - per_m * speeds_mps_[k]);
    return gain;
  }

 private:
  std::vector<double> speeds_mps_;  // (N) ascending
};

/// How much the robots park: 1 − π_v is min(1, level_m / peak_v), where peak_v = w_v / (V Σ x_e) is
/// what v costs if nobody stands there.
struct Parking {
  double level_m = 0.0;
  double moving_mps = 0.0;  // the speed that is left
};

/// The shares of parking that cost least, for rates in proportion to those given.
Parking BestParking(const std::vector<double>& peaks_m, const Team& team) {
  constexpr int kHalvings = 50;
  struct Trial {
    Parking parking;
    bool too_much = true;
  };
  const auto at = [&](double level_m) {
    double parked = 0.0;
    double cost_m = 0.0;
    for (const double peak_m : peaks_m) {
      const double unparked = std::min(1.0, level_m / peak_m);
      parked += 1.0 - unparked;
      cost_m += std::min(level_m, peak_m) * unparked;
    }
    Trial trial{.parking = {.level_m = level_m}};
    if (parked >= team.robots()) return trial;
    trial.parking.moving_mps = team.Moving_mps(parked);
    // The sign of the derivative of cost_m / moving_mps by `parked`.
    trial.too_much = cost_m * team.Next_mps(parked) > 2.0 * level_m * trial.parking.moving_mps;
    return trial;
  };
  double inverses = 0.0;
  for (const double peak_m : peaks_m) inverses += 1.0 / peak_m;
  double low = (static_cast<double>(peaks_m.size()) - team.robots()) / inverses;  // N park here
  double high = *std::max_element(peaks_m.begin(), peaks_m.end());
  Parking best{.level_m = std::numeric_limits<double>::infinity(), .moving_mps = team.total_mps()};
  if (at(high).too_much) return best;  // even the first moment of it
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    const Trial trial = at(middle);
    (trial.too_much ? low : high) = middle;
    if (!trial.too_much) best = trial.parking;
  }
  return best;
}

}  // namespace

double ClosedFormBound_m(const PatrolGraph& graph) {
  double roots = 0.0;
  for (int v = 0; v < graph.vertex_count(); ++v) {
    const auto lengths_m = graph.lengths_m(v);
    roots += std::sqrt(graph.weights()[v] * *std::min_element(lengths_m.begin(), lengths_m.end()));
  }
  return roots * roots / (2.0 * graph.vertex_count());
}

double FluidBound_m(const PatrolGraph& graph, int max_updates) {
  TraversalRates rates(graph);
  std::vector<double> pull(graph.vertex_count());
  double best_m = 0.0;
  for (int update = 0; update < max_updates; ++update) {
    const std::vector<double> at_vertex = rates.AtVertices();
    double value_m = 0.0;  // F(x)
    for (int v = 0; v < graph.vertex_count(); ++v) {
      value_m += graph.weights()[v] / (at_vertex[v] * graph.vertex_count());
      pull[v] = graph.weights()[v] / (at_vertex[v] * at_vertex[v]);
    }
    const std::vector<double> slopes = rates.Slopes(pull);
    // F is convex and ∇F(x)·x = −F(x), so F(y) ≥ 2 F(x) − max_e slope_e for every feasible y.
    const double certified_m = 2.0 * value_m - *std::max_element(slopes.begin(), slopes.end());
    if (std::isfinite(certified_m)) best_m = std::max(best_m, certified_m);
    if (!std::isfinite(value_m) || value_m - best_m <= kGap * value_m) break;
    rates.Update(slopes);
  }
  return best_m;
}

double ParkingBound_s(const PatrolGraph& graph, std::span<const double> speeds_mps,
                      int max_updates) {
  constexpr int kUpdatesPerParking = 10;
  const Team team(speeds_mps);
  const int count = graph.vertex_count();
  if (team.robots() >= count) return 0.0;
  TraversalRates rates(graph);
  std::vector<double> peaks_m(count);
  std::vector<double> pull(count);
  std::vector<double> gains_s(count);  // of parking at v for good: 2 d_v
  Parking parking;
  double best_s = 0.0;
  for (int update = 0; update < max_updates; ++update) {
    const std::vector<double> at_vertex = rates.AtVertices();
    for (int v = 0; v < count; ++v) peaks_m[v] = graph.weights()[v] / (at_vertex[v] * count);
    if (update % kUpdatesPerParking == 0) parking = BestParking(peaks_m, team);
    double value_s = 0.0;  // F(x, π)
    for (int v = 0; v < count; ++v) {
      const double dual_m = std::min(peaks_m[v], parking.level_m);
      value_s += dual_m * std::min(1.0, parking.level_m / peaks_m[v]) / parking.moving_mps;
      gains_s[v] = 2.0 * dual_m / parking.moving_mps;
      pull[v] = dual_m * dual_m * count * count / graph.weights()[v];
    }
    const std::vector<double> slopes = rates.Slopes(pull);
    const double per_m =
        *std::max_element(slopes.begin(), slopes.end()) / (parking.moving_mps * parking.moving_mps);
    // (1 − π)² c / a ≥ 2 d (1 − π) − d² a / c for every d, and a linear programme is left.
    const double certified_s = std::accumulate(gains_s.begin(), gains_s.end(), 0.0) -
                               per_m * team.total_mps() - team.ParkingGain(gains_s, per_m);
    if (std::isfinite(certified_s)) best_s = std::max(best_s, certified_s);
    if (!std::isfinite(value_s) || value_s - best_s <= kGap * value_s) break;
    rates.Update(slopes);
  }
  return best_s;
}

}  // namespace ronda
