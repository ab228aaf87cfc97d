#pragma once
// A trained policy at work on robots that are not simulated: they report where they are, it says
// where to go next.
//
// Robots are 0 … N − 1 and vertices 0 … V − 1 (graph.vertex_id has the map's names); times are
// seconds since the patrol began. What a robot decides is announced by that: the others count on it
// to be there after edge length / speed. One object may serve the whole team, or each robot may
// have its own: it then calls Decide for itself and Hear for what the others did, and all decide as
// one object would. A report may come late: it counts as of the newest that came before it. A
// robot that is overdue counts as arriving at any moment, for as long as it says nothing.
//
// Errors: InputError naming rule and value for a report that cannot be, nothing is changed then;
// from the policy's file as LoadPolicyStrategy. O(A·V + N·V) a decision. Thread-compatible.
#include <filesystem>
#include <memory>
#include <vector>

#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

/// `robot` is at `vertex`, which it has visited.
struct RobotReport {
  int robot = 0;
  int vertex = 0;
  double time_s = 0.0;  // ≥ 0
};

struct PatrolTeamOptions {
  std::vector<double> speeds_mps;  // (N), each > 0
  std::vector<int> starts;         // (N) the vertices that the robots' first reports will be from
};

class PatrolTeam {
 public:
  /// `graph` must outlive it.
  PatrolTeam(const PatrolGraph& graph, const std::filesystem::path& policy_file,
             const PatrolTeamOptions& options);

  /// The neighbour of report.vertex to go to next.
  int Decide(const RobotReport& report);
  /// What another robot decided by itself: to go on to `next_vertex`.
  void Hear(const RobotReport& report, int next_vertex);

  /// What is known: idleness, targets, AGI so far.
  const PatrolWorld& world() const { return world_; }

 private:
  void CheckVertex(int vertex) const;
  Arrival Take(const RobotReport& report);

  const PatrolGraph* graph_;
  PatrolWorld world_;
  std::unique_ptr<Strategy> strategy_;
  Rng rng_{1};  // asked for by Strategy; a policy draws nothing
};

}  // namespace ronda
