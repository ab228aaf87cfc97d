#include "common/world/bounds.h"

#include <fmt/format.h>
#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "common/base/error.h"

namespace ronda {
namespace {

/// Σ over the edges at each vertex of a value of each edge, (V).
std::vector<double> SumsAtVertices(const PatrolGraph& graph, const std::vector<double>& values) {
  std::vector<double> sums(graph.vertex_count(), 0.0);
  for (int e = 0; e < graph.edge_count(); ++e) {
    sums[graph.edges()[e].source] += values[e];
    sums[graph.edges()[e].target] += values[e];
  }
  return sums;
}

/// (Σ_v √w_v)² / (2V), w_v the shortest edge at v: each visit to v costs at least w_v / 2 on either
/// side of it, and the best split of the distance is by Cauchy–Schwarz.
double ClosedFormBound_m(const PatrolGraph& graph) {
  double roots = 0.0;
  for (int v = 0; v < graph.vertex_count(); ++v) {
    const auto lengths_m = graph.lengths_m(v);
    roots += std::sqrt(*std::min_element(lengths_m.begin(), lengths_m.end()));
  }
  return roots * roots / (2.0 * graph.vertex_count());
}

/// Row duals of min Σ l_e x_e subject to Σ_{e at v} x_e ≥ 2, x ≥ 0, as the solver leaves them, (V).
/// The slack basis is dual feasible, so the dual simplex may stop anywhere.
std::vector<double> SolvedCoveringDuals(const PatrolGraph& graph) {
  const int vertices = graph.vertex_count();
  const int edges = graph.edge_count();
  const int output_before = glp_term_out(GLP_OFF);
  const std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> problem(glp_create_prob(),
                                                                      &glp_delete_prob);
  glp_add_rows(problem.get(), vertices);
  glp_add_cols(problem.get(), edges);
  for (int v = 0; v < vertices; ++v) glp_set_row_bnds(problem.get(), v + 1, GLP_LO, 2.0, 0.0);
  for (int e = 0; e < edges; ++e) {
    const Edge& edge = graph.edges()[e];
    const int rows[] = {0, edge.source + 1, edge.target + 1};  // GLPK counts from 1
    const double coefficients[] = {0.0, 1.0, 1.0};
    glp_set_col_bnds(problem.get(), e + 1, GLP_LO, 0.0, 0.0);
    glp_set_obj_coef(problem.get(), e + 1, edge.length_m);
    glp_set_mat_col(problem.get(), e + 1, 2, rows, coefficients);
  }
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = GLP_DUAL;
  options.it_lim = 100 * (vertices + edges);
  glp_simplex(problem.get(), &options);  // whatever it returns, the duals are repaired
  std::vector<double> duals_m(vertices);
  for (int v = 0; v < vertices; ++v) duals_m[v] = glp_get_row_dual(problem.get(), v + 1);
  glp_term_out(output_before);
  return duals_m;
}

}  // namespace

double FluidBound_m(const PatrolGraph& graph) {
  constexpr int kMaxUpdates = 20000;
  constexpr double kGap = 1e-6;  // relative, between the value of x and its certificate
  const int edges = graph.edge_count();
  std::vector<double> share(edges, 1.0 / edges);  // l_e x_e, sums to 1
  std::vector<double> rates(edges);               // x_e, 1/m
  std::vector<double> slope(edges);               // (−∂F/∂x_e) / l_e, m
  double best_m = 0.0;
  for (int update = 0; update < kMaxUpdates; ++update) {
    for (int e = 0; e < edges; ++e) rates[e] = share[e] / graph.edges()[e].length_m;
    const std::vector<double> at_vertex = SumsAtVertices(graph, rates);  // 2 f_v
    double value_m = 0.0;                                                // F(x)
    for (const double rate : at_vertex) value_m += 1.0 / (rate * graph.vertex_count());
    for (int e = 0; e < edges; ++e) {
      const Edge& edge = graph.edges()[e];
      const double source = at_vertex[edge.source];
      const double target = at_vertex[edge.target];
      slope[e] = (1.0 / (source * source) + 1.0 / (target * target)) /
                 (graph.vertex_count() * edge.length_m);
    }
    // F is convex and ∇F(x)·x = −F(x), so F(y) ≥ 2 F(x) − max_e slope_e for every feasible y.
    const double certified_m = 2.0 * value_m - *std::max_element(slope.begin(), slope.end());
    if (std::isfinite(certified_m)) best_m = std::max(best_m, certified_m);
    if (!std::isfinite(value_m) || value_m - best_m <= kGap * value_m) break;
    for (int e = 0; e < edges; ++e) share[e] *= std::sqrt(slope[e]);
    const double total = std::accumulate(share.begin(), share.end(), 0.0);
    for (double& part : share) part /= total;
  }
  return std::max(best_m, ClosedFormBound_m(graph));
}

double CoveringBound_m(const PatrolGraph& graph) {
  std::vector<double> duals_m = SolvedCoveringDuals(graph);
  for (double& dual_m : duals_m) dual_m = std::isfinite(dual_m) ? std::max(dual_m, 0.0) : 0.0;
  // Feasible where π_u + π_v ≤ l_uv; lowering one dual never breaks another edge.
  for (const Edge& edge : graph.edges()) {
    const bool source_larger = duals_m[edge.source] > duals_m[edge.target];
    double& larger_m = duals_m[source_larger ? edge.source : edge.target];
    double& smaller_m = duals_m[source_larger ? edge.target : edge.source];
    smaller_m = std::min(smaller_m, edge.length_m);
    larger_m = std::min(larger_m, edge.length_m - smaller_m);
  }
  return 2.0 * std::accumulate(duals_m.begin(), duals_m.end(), 0.0);
}

double SpanningForestBound_m(const PatrolGraph& graph, int robots) {
  std::vector<Edge> edges = graph.edges();
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.length_m < b.length_m; });
  std::vector<int> parent(graph.vertex_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  // Kruskal's tree grows by ascending length, so its N − 1 longest edges are its last.
  int left = graph.vertex_count() - robots;
  double length_m = 0.0;
  for (const Edge& edge : edges) {
    if (left <= 0) break;
    const int source = root(edge.source);
    const int target = root(edge.target);
    if (source == target) continue;
    parent[source] = target;
    length_m += edge.length_m;
    --left;
  }
  return length_m;
}

LowerBounds ComputeLowerBounds(const PatrolGraph& graph, double total_speed_mps, int robots) {
  if (!std::isfinite(total_speed_mps) || total_speed_mps <= 0.0) {
    throw InputError(fmt::format("bounds: the total speed must be positive and finite, got {} m/s",
                                 total_speed_mps));
  }
  if (robots < 1) {
    throw InputError(fmt::format("bounds: there must be at least 1 robot, got {}", robots));
  }
  const double fluid_m = FluidBound_m(graph);
  const double covering_m = CoveringBound_m(graph);
  const double forest_m = SpanningForestBound_m(graph, robots);
  LowerBounds bounds{.agi_s = fluid_m / total_speed_mps,
                     .wi_s = covering_m / total_speed_mps,
                     .wi_method = "covering linear programme (dual)"};
  // No interval is longer than WI, so the mean of an idleness is at most half of it.
  if (2.0 * fluid_m > covering_m) {
    bounds.wi_s = 2.0 * fluid_m / total_speed_mps;
    bounds.wi_method = "twice the bound on the average";
  }
  if (forest_m / total_speed_mps > bounds.wi_s) {
    bounds.wi_s = forest_m / total_speed_mps;
    bounds.wi_method = "minimum spanning tree less its longest edges";
  }
  return bounds;
}

}  // namespace ronda
