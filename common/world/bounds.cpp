#include "common/world/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/base/error.h"
#include "common/world/closed_walk_bound.h"
#include "common/world/covering_bound.h"
#include "common/world/fluid_bound.h"
#include "common/world/spanning_forest.h"

namespace ronda {
namespace {

void CheckOptions(const BoundsOptions& options) {
  if (options.speeds_mps.empty()) throw InputError("bounds: there must be at least 1 robot, got 0");
  for (const double speed_mps : options.speeds_mps) {
    if (!std::isfinite(speed_mps) || speed_mps <= 0.0) {
      throw InputError(
          fmt::format("bounds: a speed must be positive and finite, got {} m/s", speed_mps));
    }
  }
}

struct Bound {
  double value_s = 0.0;
  std::string method;
};

const Bound& Largest(const std::vector<Bound>& tried) {
  return *std::max_element(tried.begin(), tried.end(),
                           [](const Bound& a, const Bound& b) { return a.value_s < b.value_s; });
}

}  // namespace

LowerBounds ComputeLowerBounds(const PatrolGraph& graph, const ShortestPaths& paths,
                               const BoundsOptions& options) {
  CheckOptions(options);
  const std::vector<double>& speeds_mps = options.speeds_mps;
  const int robots = static_cast<int>(speeds_mps.size());
  const double total_mps = std::accumulate(speeds_mps.begin(), speeds_mps.end(), 0.0);
  std::vector<Bound> agi;
  std::vector<Bound> wi;
  if (options.staying) {
    agi = {{ParkingBound_s(graph, speeds_mps), "rates of traversal and shares of parking"}};
    wi = {{ParkedCoveringBound_s(graph, speeds_mps), "covering linear programme with parking"}};
  } else {
    agi = {{FluidBound_m(graph) / total_mps, "rates of traversal"},
           {ClosedFormBound_m(graph) / total_mps, "shortest edge at each vertex"}};
    wi = {{CoveringBound_m(graph) / total_mps, "covering linear programme"}};
  }
  const Bound& best_agi = Largest(agi);
  wi.push_back({2.0 * best_agi.value_s, "twice the bound on the average"});
  wi.push_back({SpanningForestBound_m(graph, paths, robots) / total_mps,
                "minimum spanning tree less its longest edges"});
  if (robots == 1) {
    const auto weights = graph.weights();
    const double least_weight = *std::min_element(weights.begin(), weights.end());
    wi.push_back({least_weight * ClosedWalkLowerBound(graph, paths).length_m / total_mps,
                  "shortest closed walk"});
  }
  const Bound& best_wi = Largest(wi);
  return {.agi_s = best_agi.value_s,
          .agi_method = best_agi.method,
          .wi_s = best_wi.value_s,
          .wi_method = best_wi.method};
}

}  // namespace ronda
