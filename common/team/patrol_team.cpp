#include "common/team/patrol_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/base/error.h"
#include "common/team/policy_strategy.h"
#include "common/world/team_beliefs.h"

namespace ronda {

PatrolTeam::PatrolTeam(const PatrolGraph& graph, const std::filesystem::path& policy_file,
                       const PatrolTeamOptions& options)
    : graph_(&graph), world_(graph, {.speeds_mps = options.speeds_mps}) {
  if (options.starts.size() != options.speeds_mps.size()) {
    throw InputError(fmt::format("a team needs one start for each robot, got {} for {}",
                                 options.starts.size(), options.speeds_mps.size()));
  }
  std::vector<RobotStart> starts;
  for (const int vertex : options.starts) {
    CheckVertex(vertex);
    starts.push_back({.vertex = vertex, .next = vertex});
  }
  const ShortestPaths paths(graph);
  strategy_ = LoadPolicyStrategy(policy_file, {.graph = &graph, .paths = &paths});
  strategy_->Begin(graph, options.speeds_mps, rng_);  // refuses a team that it does not fit
  world_.Reset(starts, rng_);
}

int PatrolTeam::Decide(const RobotReport& report) {
  const Arrival arrival = Take(report);
  const int next_vertex = strategy_->Decide(CompleteBelief(world_, arrival.robot), rng_);
  world_.Depart(report.robot, next_vertex);
  return next_vertex;
}

void PatrolTeam::Hear(const RobotReport& report, int next_vertex) {
  CheckVertex(report.vertex);
  const auto neighbours = graph_->neighbours(report.vertex);
  if (!std::binary_search(neighbours.begin(), neighbours.end(), next_vertex)) {
    throw InputError(fmt::format("robot {}: no edge from vertex {} to {}", report.robot,
                                 report.vertex, next_vertex));
  }
  Take(report);
  world_.Depart(report.robot, next_vertex);
}

void PatrolTeam::CheckVertex(int vertex) const {
  if (vertex < 0 || vertex >= graph_->vertex_count()) {
    throw InputError(
        fmt::format("a vertex must be 0 to {}, got {}", graph_->vertex_count() - 1, vertex));
  }
}

Arrival PatrolTeam::Take(const RobotReport& report) {
  CheckVertex(report.vertex);
  if (report.robot < 0 || report.robot >= world_.robot_count()) {
    throw InputError(
        fmt::format("a robot must be 0 to {}, got {}", world_.robot_count() - 1, report.robot));
  }
  if (!(report.time_s >= 0.0) || !std::isfinite(report.time_s)) {
    throw InputError(fmt::format("robot {}: a time must be ≥ 0 s and finite, got {}", report.robot,
                                 report.time_s));
  }
  const double on_grid_s = std::nearbyint(report.time_s / kTimeStep_s) * kTimeStep_s;
  return world_.Arrive(report.robot, report.vertex, std::max(on_grid_s, world_.time_s()));
}

}  // namespace ronda
