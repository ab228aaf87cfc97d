// Decisions a second on one core: each strategy on Cumberland with 10 robots, and the same as a
// ratio to the bare event loop that always takes a vertex's first neighbour.
//
//   world_bench [MILLIONS]    decisions of each run, default 5; the best of 5 interleaved runs
//   counts
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "common/run/paths.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"
#include "common/world/strategies/strategy.h"

namespace ronda {
namespace {

constexpr int kRobots = 10;
constexpr int kRuns = 5;

class FirstNeighbour final : public Strategy {
 public:
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& belief, Rng& /*rng*/) override {
    return belief.graph->neighbours(belief.vertex)[0];
  }
};

double DecisionsPerSecond(const PatrolGraph& graph, Strategy& strategy, long decisions) {
  const std::vector<double> speeds_mps(kRobots, 1.0);
  Rng rng = SplitSeed(1, 0);
  PatrolWorld world(graph, {.speeds_mps = speeds_mps});
  TeamBeliefs beliefs(graph, kRobots, strategy.knowledge(), {});
  world.Reset(strategy.Begin(graph, speeds_mps, rng), SplitSeed(1, 1));
  beliefs.Begin(world, Rng(1));
  const auto begin = std::chrono::steady_clock::now();
  for (long i = 0; i < decisions; ++i) {
    PlayNext(world, beliefs, strategy, 1e18, rng);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return static_cast<double>(decisions) / elapsed.count();
}

void Run(long decisions) {
  const PatrolGraph graph =
      LoadMap("cumberland", MapsFolder(), EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  const ClosedWalk walk = ClosedWalkOf(graph, paths);
  std::vector<std::string> names{"first neighbour"};
  std::vector<std::unique_ptr<Strategy>> strategies;
  strategies.push_back(std::make_unique<FirstNeighbour>());
  for (const std::string& name : AllStrategyNames()) {
    names.push_back(name);
    strategies.push_back(
        MakeStrategy(name, {.graph = &graph, .paths = &paths, .closed_walk = &walk}));
  }
  std::vector<double> best(names.size(), 0.0);
  for (int run = 0; run < kRuns; ++run) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      best[i] = std::max(best[i], DecisionsPerSecond(graph, *strategies[i], decisions));
    }
  }
  fmt::print("cumberland, {} robots, one core, best of {} runs of {} decisions\n", kRobots, kRuns,
             decisions);
  for (std::size_t i = 0; i < names.size(); ++i) {
    fmt::print("  {:<16} {:7.2f} M decisions/s   {:.2f} of the bare loop\n", names[i],
               best[i] / 1e6, best[i] / best[0]);
  }
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 5.0;
  ronda::Run(std::max(1L, static_cast<long>(millions * 1e6)));
  return 0;
}
