// What a decision costs as maps and teams grow: each strategy on random maps of 10 to 10 000
// vertices with 10 robots, then on one of 1000 vertices with 1 to 1000 robots; nanoseconds a
// decision on one core, and how it grows over the last tenfold step.
//
//   world_scaling_bench [SECONDS]    of each strategy in each of 5 rounds, default 0.05
//
// Beside it the seconds of what is made once for a map (all shortest paths, a short closed walk).
// Takes about 2 minutes and 4 GB, nearly all for the largest map.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "bench/played_team.h"
#include "common/world/closed_walk.h"
#include "common/world/random_graph.h"

namespace ronda::bench {
namespace {

constexpr int kRounds = 5;

struct Size {
  int vertices;
  int robots;
};

std::vector<double> Nanoseconds(const Size& size, double slice_s) {
  const PatrolGraph graph = RandomGeometricGraph({.vertices = size.vertices, .seed = 1});
  double start_s = ThreadTime_s();
  const ShortestPaths paths(graph);
  fmt::print("{} vertices, {} robots: shortest paths {:.3g} s", size.vertices, size.robots,
             ThreadTime_s() - start_s);
  std::fflush(stdout);
  start_s = ThreadTime_s();
  const ClosedWalk walk = ClosedWalkOf(graph, paths);
  fmt::print(", closed walk {:.3g} s\n", ThreadTime_s() - start_s);
  std::fflush(stdout);
  std::vector<double> cost_ns;
  for (const Rates& rates : DecisionRates({.graph = &graph, .paths = &paths, .closed_walk = &walk},
                                          size.robots, slice_s, kRounds)) {
    cost_ns.push_back(1e9 / Median(rates));
  }
  return cost_ns;
}

void Table(const std::string& title, const std::vector<Size>& sizes, double slice_s) {
  std::vector<std::vector<double>> cost_ns;
  for (const Size& size : sizes) cost_ns.push_back(Nanoseconds(size, slice_s));
  fmt::print("{}\n", title);
  std::vector<std::string> names = AllStrategyNames();
  names.insert(names.begin(), "first neighbour");
  for (std::size_t i = 0; i < names.size(); ++i) {
    fmt::print("  {:<16}", names[i]);
    for (const auto& cost : cost_ns) fmt::print(" {:10.0f}", cost[i]);
    const double step = cost_ns.back()[i] / cost_ns[cost_ns.size() - 2][i];
    fmt::print("   {:5.2f}\n", std::log10(step));
  }
}

void Run(double slice_s) {
  Table("ns a decision at V = 10, 100, 1000, 10 000 with N = 10, and x of V^x over the last step",
        {{10, 10}, {100, 10}, {1000, 10}, {10'000, 10}}, slice_s);
  Table("ns a decision at N = 1, 10, 100, 1000 with V = 1000, and x of N^x over the last step",
        {{1000, 1}, {1000, 10}, {1000, 100}, {1000, 1000}}, slice_s);
}

}  // namespace
}  // namespace ronda::bench

int main(int argc, char** argv) {
  ronda::bench::Run(argc > 1 ? std::atof(argv[1]) : 0.05);
  return 0;
}
