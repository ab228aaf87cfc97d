#include "common/world/covering_bound.h"

#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace ronda {
namespace {

using Problem = std::unique_ptr<glp_prob, decltype(&glp_delete_prob)>;

/// min Σ l_e x_e subject to Σ_{e at v} x_e ≥ 2 w_v, x ≥ 0: a row for each vertex, a column for each
/// edge. GLPK counts from 1.
Problem CoveringProblem(const PatrolGraph& graph) {
  Problem problem(glp_create_prob(), &glp_delete_prob);
  glp_add_rows(problem.get(), graph.vertex_count());
  glp_add_cols(problem.get(), graph.edge_count());
  for (int v = 0; v < graph.vertex_count(); ++v) {
    glp_set_row_bnds(problem.get(), v + 1, GLP_LO, 2.0 * graph.weights()[v], 0.0);
  }
  for (int e = 0; e < graph.edge_count(); ++e) {
    const Edge& edge = graph.edges()[e];
    const int rows[] = {0, edge.source + 1, edge.target + 1};
    const double coefficients[] = {0.0, 1.0, 1.0};
    glp_set_col_bnds(problem.get(), e + 1, GLP_LO, 0.0, 0.0);
    glp_set_obj_coef(problem.get(), e + 1, edge.length_m);
    glp_set_mat_col(problem.get(), e + 1, 2, rows, coefficients);
  }
  return problem;
}

/// With shares π_v of parking the rows ask for 2 w_v (1 − π_v), and the robots of each speed, who
/// park for q in all, lose q times that speed. The quotient of length and speed becomes linear
/// (Charnes & Cooper 1962) when x, π and q are multiplied by τ = 1 / speed.
void AddParking(glp_prob* problem, const PatrolGraph& graph, std::span<const double> speeds_mps) {
  std::map<double, int> robots_of;  // by speed
  for (const double speed_mps : speeds_mps) ++robots_of[speed_mps];
  const int vertices = graph.vertex_count();
  const int kinds = static_cast<int>(robots_of.size());
  const int speed_row = glp_add_rows(problem, 2 + kinds);  // τ Σ s − Σ s q ≥ 1
  const int shares_row = speed_row + 1;                    // Σ q − Σ π ≥ 0
  const int parking = glp_add_cols(problem, vertices + kinds + 1);
  const int inverse = parking + vertices + kinds;  // τ
  const auto column = [&](int number, std::vector<int> rows, std::vector<double> coefficients) {
    glp_set_col_bnds(problem, number, GLP_LO, 0.0, 0.0);
    glp_set_mat_col(problem, number, static_cast<int>(rows.size()) - 1, rows.data(),
                    coefficients.data());
  };
  std::vector<int> rows{0, speed_row};  // those of τ
  std::vector<double> coefficients{0.0, std::accumulate(speeds_mps.begin(), speeds_mps.end(), 0.0)};
  for (int v = 0; v < vertices; ++v) {
    const double visits = 2.0 * graph.weights()[v];
    glp_set_row_bnds(problem, v + 1, GLP_LO, 0.0, 0.0);  // Σ x + 2 w π − 2 w τ ≥ 0
    column(parking + v, {0, v + 1, shares_row}, {0.0, visits, -1.0});
    rows.push_back(v + 1);
    coefficients.push_back(-visits);
  }
  int kind = 0;
  for (const auto& [speed_mps, robots] : robots_of) {
    const int kind_row = shares_row + ++kind;  // robots τ − q ≥ 0
    glp_set_row_bnds(problem, kind_row, GLP_LO, 0.0, 0.0);
    column(parking + vertices + kind - 1, {0, speed_row, shares_row, kind_row},
           {0.0, -speed_mps, 1.0, -1.0});
    rows.push_back(kind_row);
    coefficients.push_back(robots);
  }
  glp_set_row_bnds(problem, speed_row, GLP_LO, 1.0, 0.0);
  glp_set_row_bnds(problem, shares_row, GLP_LO, 0.0, 0.0);
  column(inverse, std::move(rows), std::move(coefficients));
}

/// The duals of the vertices' rows as the solver leaves them, made feasible. All costs are
/// positive, so the slack basis is dual feasible.
std::vector<double> SolvedDuals_m(const PatrolGraph& graph, glp_prob* problem) {
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = GLP_DUAL;
  options.it_lim = 100 * (graph.vertex_count() + graph.edge_count());
  const int output_before = glp_term_out(GLP_OFF);
  glp_simplex(problem, &options);  // whatever it returns, the duals are repaired
  glp_term_out(output_before);
  std::vector<double> duals_m(graph.vertex_count());
  for (int v = 0; v < graph.vertex_count(); ++v) duals_m[v] = glp_get_row_dual(problem, v + 1);
  return FeasibleCoveringDuals_m(graph, std::move(duals_m));
}

}  // namespace

std::vector<double> FeasibleCoveringDuals_m(const PatrolGraph& graph, std::vector<double> duals_m) {
  for (double& dual_m : duals_m) dual_m = std::isfinite(dual_m) ? std::max(dual_m, 0.0) : 0.0;
  // Lowering one dual never breaks another edge.
  for (const Edge& edge : graph.edges()) {
    const bool source_larger = duals_m[edge.source] > duals_m[edge.target];
    double& larger_m = duals_m[source_larger ? edge.source : edge.target];
    double& smaller_m = duals_m[source_larger ? edge.target : edge.source];
    smaller_m = std::min(smaller_m, edge.length_m);
    larger_m = std::min(larger_m, edge.length_m - smaller_m);
  }
  return duals_m;
}

double CoveringBoundOf_m(const PatrolGraph& graph, std::span<const double> duals_m) {
  return 2.0 * std::inner_product(duals_m.begin(), duals_m.end(), graph.weights().begin(), 0.0);
}

double ParkedCoveringBoundOf_s(const PatrolGraph& graph, std::span<const double> speeds_mps,
                               std::span<const double> duals_m) {
  std::vector<double> demands_m(duals_m.size());  // 2 w_v y_v, what v adds to the bound
  for (std::size_t v = 0; v < duals_m.size(); ++v) {
    demands_m[v] = 2.0 * graph.weights()[v] * duals_m[v];
  }
  std::sort(demands_m.begin(), demands_m.end());
  std::vector<double> speeds(speeds_mps.begin(), speeds_mps.end());
  std::sort(speeds.begin(), speeds.end(), std::greater<>());
  if (speeds.size() >= demands_m.size()) return 0.0;
  // At least one robot moves, since no N vertices are all. The quotient is least where, for some
  // k < N, the k slowest park at the k vertices that demand most.
  const auto count = static_cast<std::ptrdiff_t>(demands_m.size() - speeds.size());
  double left_m = std::accumulate(demands_m.begin(), demands_m.begin() + count, 0.0);
  double left_mps = 0.0;
  double least_s = std::numeric_limits<double>::infinity();
  for (std::size_t moving = 0; moving < speeds.size(); ++moving) {
    left_m += demands_m[demands_m.size() - speeds.size() + moving];
    left_mps += speeds[moving];
    least_s = std::min(least_s, left_m / left_mps);
  }
  return least_s;
}

std::vector<double> CoveringDuals_m(const PatrolGraph& graph) {
  return SolvedDuals_m(graph, CoveringProblem(graph).get());
}

double CoveringBound_m(const PatrolGraph& graph) {
  return CoveringBoundOf_m(graph, CoveringDuals_m(graph));
}

double ParkedCoveringBound_s(const PatrolGraph& graph, std::span<const double> speeds_mps) {
  const Problem problem = CoveringProblem(graph);
  AddParking(problem.get(), graph, speeds_mps);
  return ParkedCoveringBoundOf_s(graph, speeds_mps, SolvedDuals_m(graph, problem.get()));
}

}  // namespace ronda
