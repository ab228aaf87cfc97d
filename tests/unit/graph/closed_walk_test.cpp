#include "common/world/closed_walk.h"

#include <glpk.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <memory>
#include <numeric>
#include <set>

#include "tests/unit/graph/graphs.h"

namespace ronda {
namespace {

/// Throws unless it is a closed walk along edges, through all vertices, of its length.
void CheckIsClosedWalk(const PatrolGraph& graph, const ClosedWalk& walk) {
  GraphData data{.name = "",
                 .vertex_ids = {},
                 .positions = graph.positions(),
                 .edges = graph.edges(),
                 .shortest_closed_walk = walk};
  for (int v = 0; v < graph.vertex_count(); ++v) data.vertex_ids.push_back(graph.vertex_id(v));
  CHECK_NOTHROW(PatrolGraph(data));
}

/// The component of each vertex, by its lowest vertex, in the graph of the edges with x_e ≥ ½.
std::vector<int> Components(const PatrolGraph& graph, glp_prob* problem) {
  std::vector<int> component(graph.vertex_count());
  std::iota(component.begin(), component.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (int e = 0; e < graph.edge_count(); ++e) {
      int& a = component[graph.edges()[e].source];
      int& b = component[graph.edges()[e].target];
      if (glp_mip_col_val(problem, e + 1) < 0.5 || a == b) continue;
      a = b = std::min(a, b);
      changed = true;
    }
  }
  return component;
}

/// Adds x(δ(S)) ≥ 2 for the set S of vertices of one component.
void AddCut(const PatrolGraph& graph, glp_prob* problem, const std::vector<int>& component,
            int cut_off) {
  std::vector<int> columns{0};
  for (int e = 0; e < graph.edge_count(); ++e) {
    const bool source_in = component[graph.edges()[e].source] == cut_off;
    const bool target_in = component[graph.edges()[e].target] == cut_off;
    if (source_in != target_in) columns.push_back(e + 1);
  }
  const std::vector<double> ones(columns.size(), 1.0);
  const int row = glp_add_rows(problem, 1);
  glp_set_row_bnds(problem, row, GLP_LO, 2.0, 0.0);
  glp_set_mat_row(problem, row, static_cast<int>(columns.size()) - 1, columns.data(), ones.data());
}

/// The shortest closed walk through all vertices, exactly: each edge 0, 1 or 2 times, an even
/// number at each vertex, and connected (cuts added while the solution falls apart). Cornuéjols,
/// Fonlupt & Naddef 1985.
double ExactShortestClosedWalk_m(const PatrolGraph& graph) {
  const int edges = graph.edge_count();
  const std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> problem(glp_create_prob(),
                                                                      &glp_delete_prob);
  glp_term_out(GLP_OFF);
  glp_add_cols(problem.get(), edges + graph.vertex_count());
  for (int e = 0; e < edges; ++e) {
    glp_set_col_kind(problem.get(), e + 1, GLP_IV);
    glp_set_col_bnds(problem.get(), e + 1, GLP_DB, 0.0, 2.0);
    glp_set_obj_coef(problem.get(), e + 1, graph.edges()[e].length_m);
  }
  for (int v = 0; v < graph.vertex_count(); ++v) {
    const int visits = edges + v + 1;  // half the number of edges at v
    glp_set_col_kind(problem.get(), visits, GLP_IV);
    glp_set_col_bnds(problem.get(), visits, GLP_LO, 1.0, 0.0);
    std::vector<int> columns{0, visits};
    std::vector<double> coefficients{0.0, -2.0};
    for (int e = 0; e < edges; ++e) {
      if (graph.edges()[e].source != v && graph.edges()[e].target != v) continue;
      columns.push_back(e + 1);
      coefficients.push_back(1.0);
    }
    const int row = glp_add_rows(problem.get(), 1);
    glp_set_row_bnds(problem.get(), row, GLP_FX, 0.0, 0.0);
    glp_set_mat_row(problem.get(), row, static_cast<int>(columns.size()) - 1, columns.data(),
                    coefficients.data());
  }
  glp_iocp options;
  glp_init_iocp(&options);
  options.presolve = GLP_ON;
  options.msg_lev = GLP_MSG_OFF;
  options.mir_cuts = GLP_ON;
  options.gmi_cuts = GLP_ON;
  while (true) {
    REQUIRE(glp_intopt(problem.get(), &options) == 0);
    REQUIRE(glp_mip_status(problem.get()) == GLP_OPT);
    const std::vector<int> component = Components(graph, problem.get());
    const std::set<int> parts(component.begin(), component.end());
    if (parts.size() == 1) break;
    for (const int part : parts) AddCut(graph, problem.get(), component, part);
  }
  return glp_mip_obj_val(problem.get());
}

TEST_CASE("no closed walk of a shipped map is shorter than the one that ships") {
  const std::string name = GENERATE("4nodes", "cumberland", "grid", "milwaukee");
  CAPTURE(name);
  const PatrolGraph graph = testing::ShippedMap(name);
  CHECK(graph.shortest_closed_walk()->length_m ==
        Approx(ExactShortestClosedWalk_m(graph)).epsilon(1e-6));
}

TEST_CASE("the search finds a shortest closed walk of each shipped map") {
  const std::string name = GENERATE("4nodes", "cumberland", "grid", "milwaukee");
  const auto seed = GENERATE(range<std::uint64_t>(1, 4));
  CAPTURE(name, seed);
  const PatrolGraph graph = testing::ShippedMap(name);

  const ClosedWalk sut = FindShortestClosedWalk(graph, ShortestPaths(graph), seed);

  CHECK(sut.length_m == Approx(graph.shortest_closed_walk()->length_m).epsilon(1e-9));
  CheckIsClosedWalk(graph, sut);
}

TEST_CASE("what is found is a closed walk, no shorter than the exact one, on random graphs") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 7));
  CAPTURE(seed);
  const PatrolGraph graph(testing::RandomGraphData(15, 10, seed));

  const ClosedWalk sut = FindShortestClosedWalk(graph, ShortestPaths(graph), seed);

  CheckIsClosedWalk(graph, sut);
  const double exact_m = ExactShortestClosedWalk_m(graph);
  CHECK(sut.length_m >= exact_m * (1.0 - 1e-6));
  CHECK(sut.length_m <= exact_m * 1.02);
}

TEST_CASE("two vertices make a walk there and back, a tree one that takes each edge twice") {
  const int vertices = GENERATE(2, 3, 4, 5, 20);
  CAPTURE(vertices);
  const PatrolGraph graph(testing::RandomGraphData(vertices, 0, 5));

  const ClosedWalk sut = FindShortestClosedWalk(graph, ShortestPaths(graph), 1);

  const double tree_m = graph.mean_edge_length_m() * graph.edge_count();
  CHECK(sut.length_m == Approx(2.0 * tree_m).epsilon(1e-9));
  CHECK(sut.vertices.size() == static_cast<std::size_t>(2 * graph.edge_count()));
  CheckIsClosedWalk(graph, sut);
}

TEST_CASE("the same seed finds the same walk") {
  const PatrolGraph graph(testing::RandomGraphData(60, 60, 9));
  const ShortestPaths paths(graph);
  CHECK(FindShortestClosedWalk(graph, paths, 4).vertices ==
        FindShortestClosedWalk(graph, paths, 4).vertices);
}

TEST_CASE("a map without a walk gets one that says that it is an upper value") {
  const PatrolGraph graph(testing::RandomGraphData(10, 5, 2));
  CHECK_THAT(ClosedWalkOf(graph, ShortestPaths(graph)).source,
             Catch::Matchers::Contains("upper value"));
}

}  // namespace
}  // namespace ronda
