#include "common/world/strategies/cyclic.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {

std::vector<RobotStart> Cyclic::Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                      Rng& /*rng*/) {
  const auto& walk = walk_->vertices;
  const double tolerance_m = 1e-9 * walk_->length_m;  // closer than this to a vertex: on it
  std::vector<RobotStart> starts;
  index_.clear();
  std::size_t index = 0;     // the edge walk[index] → walk[index + 1] …
  double edge_from_m = 0.0;  // … and how far along the walk it begins
  for (std::size_t robot = 0; robot < speeds_mps.size(); ++robot) {
    const double place_m =
        walk_->length_m * static_cast<double>(robot) / static_cast<double>(speeds_mps.size());
    double edge_m = graph.edge_length_m(walk[index], walk[After(index)]);
    while (place_m > edge_from_m + edge_m - tolerance_m && index + 1 < walk.size()) {
      edge_from_m += edge_m;
      ++index;
      edge_m = graph.edge_length_m(walk[index], walk[After(index)]);
    }
    const bool on_vertex = place_m < edge_from_m + tolerance_m;
    const int next = walk[After(index)];
    starts.push_back({.vertex = walk[index],
                      .next = on_vertex ? walk[index] : next,
                      .remaining_m = on_vertex ? 0.0 : edge_from_m + edge_m - place_m});
    index_.push_back(on_vertex ? index : After(index));
  }
  return starts;
}

int Cyclic::Decide(const Belief& belief, Rng& /*rng*/) {
  const auto& walk = walk_->vertices;
  std::size_t& index = index_[belief.robot];
  if (walk[index] != belief.vertex) {  // it has joined again, where it started
    index = static_cast<std::size_t>(std::ranges::find(walk, belief.vertex) - walk.begin());
    RONDA_CHECK(index < walk.size(), "robot {} is at {}, off the walk", belief.robot,
                belief.vertex);
  }
  index = After(index);
  return walk[index];
}

}  // namespace ronda
