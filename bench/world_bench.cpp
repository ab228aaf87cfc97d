// Decisions a second on one core: each strategy on Cumberland with 10 robots, and the same as a
// ratio to the bare event loop that always takes a vertex's first neighbour.
//
//   world_bench [SECONDS]    of each strategy in each of 7 rounds, default 0.2
#include <fmt/format.h>

#include <cstdlib>

#include "bench/played_team.h"
#include "common/run/paths.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"

namespace ronda::bench {
namespace {

constexpr int kRobots = 10;
constexpr int kRounds = 7;

void Run(double slice_s) {
  const PatrolGraph graph =
      LoadMap("cumberland", MapsFolder(), EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  const ClosedWalk walk = ClosedWalkOf(graph, paths);
  const auto rates = DecisionRates({.graph = &graph, .paths = &paths, .closed_walk = &walk},
                                   kRobots, slice_s, kRounds);
  fmt::print("cumberland, {} robots, one core, median of {} rounds of {} s\n", kRobots, kRounds,
             slice_s);
  std::vector<std::string> names = AllStrategyNames();
  names.insert(names.begin(), "first neighbour");
  for (std::size_t i = 0; i < names.size(); ++i) {
    fmt::print("  {:<16} {:7.2f} M decisions/s   {:.2f} of the bare loop\n", names[i],
               Median(rates[i]) / 1e6, MedianRatio(rates[i], rates[0]));
  }
}

}  // namespace
}  // namespace ronda::bench

int main(int argc, char** argv) {
  ronda::bench::Run(argc > 1 ? std::atof(argv[1]) : 0.2);
  return 0;
}
