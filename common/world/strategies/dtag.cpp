#include "common/world/strategies/dtag.h"

#include <algorithm>
#include <cmath>

#include "common/world/strategies/random_argmax.h"

namespace ronda {

std::vector<RobotStart> GreedyAssignment::Begin(const PatrolGraph& graph,
                                                std::span<const double> speeds_mps, Rng& rng) {
  constexpr double kInitialIdleness_s = 100.0;
  starts_ = Strategy::Begin(graph, speeds_mps, rng);
  idleness_.Begin(graph, starts_, kInitialIdleness_s);
  goals_.assign(starts_.size() * starts_.size(), -1);
  return starts_;
}

int GreedyAssignment::Decide(const Belief& belief, Rng& rng) {
  int& own = goal(belief.robot, belief.robot);
  if (belief.previous_vertex < 0 || own < 0 || own == belief.vertex) own = ChooseGoal(belief, rng);
  return paths_->next_hop(belief.vertex, own);
}

void GreedyAssignment::Hear(int receiver, int sender) {
  goal(receiver, sender) = goal(sender, sender);
}

void GreedyAssignment::FindFree(const Belief& belief) {
  free_.assign(static_cast<std::size_t>(belief.graph->vertex_count()), 1);
  free_[belief.vertex] = 0;
  for (int other = 0; other < belief.robot_count(); ++other) {
    const int taken = goal(belief.robot, other);
    if (other != belief.robot && taken >= 0 && belief.on_patrol[other] != 0) free_[taken] = 0;
  }
  if (std::count(free_.begin(), free_.end(), 1) > 0) return;
  std::fill(free_.begin(), free_.end(), 1);
  free_[belief.vertex] = 0;
}

int GreedyAssignment::ChooseGoal(const Belief& belief, Rng& rng) {
  constexpr double kPerPx_s = 0.75;
  constexpr double kPerMetreFromStart_s = 5.0;
  const PatrolGraph& graph = *belief.graph;
  const Position& start = graph.positions()[starts_[belief.robot].vertex];
  const double* const distances_m = paths_->distances_from(belief.vertex);
  FindFree(belief);
  RandomArgmax choice(rng);
  for (int vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    if (free_[vertex] == 0) continue;
    const Position& place = graph.positions()[vertex];
    choice.Offer(vertex, idleness_.idleness_s(belief, vertex) -
                             kPerPx_s * distances_m[vertex] / graph.metres_per_px() -
                             kPerMetreFromStart_s *
                                 std::hypot(place.x_m - start.x_m, place.y_m - start.y_m));
  }
  return choice.best();
}

}  // namespace ronda
