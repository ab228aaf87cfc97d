#pragma once
// A shipped map with what an evaluation needs of it.
#include <string>

#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"
#include "common/world/strategies/strategy.h"

namespace ronda::testing {

struct EvaluationMap {
  explicit EvaluationMap(const std::string& name)
      : graph(LoadMap(name, RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr)) {}
  EvaluationMap(const EvaluationMap&) = delete;
  EvaluationMap& operator=(const EvaluationMap&) = delete;

  StrategyContext context() const {
    return {.graph = &graph, .paths = &paths, .closed_walk = &walk};
  }

  PatrolGraph graph;
  ShortestPaths paths{graph};
  ClosedWalk walk = ClosedWalkOf(graph, paths);
};

}  // namespace ronda::testing
