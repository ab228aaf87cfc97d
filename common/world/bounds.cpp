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

/// The largest, the first among equals.
const LowerBound& Best(const std::vector<LowerBound>& tried) {
  return *std::max_element(
      tried.begin(), tried.end(),
      [](const LowerBound& a, const LowerBound& b) { return a.value_s < b.value_s; });
}

}  // namespace

LowerBounds ComputeLowerBounds(const PatrolGraph& graph, const ShortestPaths& paths,
                               const BoundsOptions& options) {
  CheckOptions(options);
  const std::vector<double>& speeds_mps = options.speeds_mps;
  const int robots = static_cast<int>(speeds_mps.size());
  const double total_mps = std::accumulate(speeds_mps.begin(), speeds_mps.end(), 0.0);
  LowerBounds bounds;
  if (options.staying) {
    bounds.agi_tried = {
        {"rates of traversal and shares of parking", ParkingBound_s(graph, speeds_mps)}};
    bounds.wi_tried = {{"covering linear programme with parking (dual)",
                        ParkedCoveringBound_s(graph, speeds_mps)}};
  } else {
    bounds.agi_tried = {{"rates of traversal", FluidBound_m(graph) / total_mps},
                        {"shortest edge at each vertex", ClosedFormBound_m(graph) / total_mps}};
    bounds.wi_tried = {{"covering linear programme (dual)", CoveringBound_m(graph) / total_mps}};
  }
  bounds.agi_s = Best(bounds.agi_tried).value_s;
  bounds.agi_method = Best(bounds.agi_tried).method;
  // A vertex of idleness at most WI / w has a mean of at most half of that.
  bounds.wi_tried.push_back({"twice the bound on the average", 2.0 * bounds.agi_s});
  bounds.wi_tried.push_back({"minimum spanning tree less its longest edges",
                             SpanningForestBound_m(graph, paths, robots) / total_mps});
  if (robots == 1) {
    // Between two visits of the vertex that is visited last, the robot goes round all the others.
    const auto weights = graph.weights();
    bounds.wi_tried.push_back(
        {"shortest closed walk", *std::min_element(weights.begin(), weights.end()) *
                                     ClosedWalkLowerBound(graph, paths).length_m / total_mps});
  }
  bounds.wi_s = Best(bounds.wi_tried).value_s;
  bounds.wi_method = Best(bounds.wi_tried).method;
  return bounds;
}

}  // namespace ronda
