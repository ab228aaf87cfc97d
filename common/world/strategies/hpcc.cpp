#include "common/world/strategies/hpcc.h"

#include <algorithm>
#include <functional>

#include "common/world/strategies/random_argmax.h"
#include "common/world/strategies/share_of.h"

namespace ronda {

HeuristicPathfinder::HeuristicPathfinder(const PatrolGraph& graph, const ShortestPaths& paths)
    : paths_(&paths) {
  const int vertices = graph.vertex_count();
  double shortest_m = kNever_s;
  double longest_m = 0.0;
  for (const Edge& edge : graph.edges()) {
    shortest_m = std::min(shortest_m, edge.length_m);
    longest_m = std::max(longest_m, edge.length_m);
  }
  for (int vertex = 0; vertex < vertices; ++vertex) {
    const double* const row_m = paths.distances_from(vertex);
    farthest_m_.push_back(*std::max_element(row_m, row_m + vertices));
    for (const double length_m : graph.lengths_m(vertex)) {
      length_share_.push_back(ShareOf(length_m - shortest_m, longest_m - shortest_m));
    }
  }
  best_.resize(static_cast<std::size_t>(vertices));
  previous_.resize(best_.size());
  open_.reserve(length_share_.size() + 1);  // each arc is entered at most once
}

std::vector<RobotStart> HeuristicPathfinder::Begin(const PatrolGraph& graph,
                                                   std::span<const double> speeds_mps, Rng& rng) {
  ways_.resize(speeds_mps.size());
  for (auto& way : ways_) way.clear();
  return Strategy::Begin(graph, speeds_mps, rng);
}

int HeuristicPathfinder::Decide(const Belief& belief, Rng& rng) {
  std::vector<int>& way = ways_[belief.robot];
  if (belief.previous_vertex < 0 || way.size() < 2 || way.back() != belief.vertex) {
    double most_idle_s = 0.0;
    for (int vertex = 0; vertex < belief.graph->vertex_count(); ++vertex) {
      most_idle_s = std::max(most_idle_s, belief.idleness_s(vertex));
    }
    FindWay(belief, most_idle_s, ChooseGoal(belief, most_idle_s, rng));
  }
  way.pop_back();
  return way.back();
}

int HeuristicPathfinder::ChooseGoal(const Belief& belief, double most_idle_s, Rng& rng) const {
  const double farthest_m = farthest_m_[belief.vertex];
  const double* const distances_m = paths_->distances_from(belief.vertex);
  RandomArgmax choice(rng);
  for (int vertex = 0; vertex < belief.graph->vertex_count(); ++vertex) {
    if (vertex == belief.vertex) continue;
    choice.Offer(vertex, ShareOf(farthest_m - distances_m[vertex], farthest_m) +
                             ShareOf(belief.idleness_s(vertex), most_idle_s));
  }
  return choice.best();
}

void HeuristicPathfinder::FindWay(const Belief& belief, double most_idle_s, int goal) {
  const PatrolGraph& graph = *belief.graph;
  std::fill(best_.begin(), best_.end(), Cost{.weight = kNever_s});
  best_[belief.vertex] = {.vertex = belief.vertex};
  open_.assign(1, best_[belief.vertex]);
  while (true) {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const Cost at = open_.back();
    open_.pop_back();
    if (at.vertex == goal) break;
    if (at != best_[at.vertex]) continue;  // stale
    const auto neighbours = graph.neighbours(at.vertex);
    const auto lengths_m = graph.lengths_m(at.vertex);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const int next = neighbours[k];
      const double idle_share = ShareOf(most_idle_s - belief.idleness_s(next), most_idle_s);
      const Cost reached{
          .weight = at.weight + idle_share + length_share_[graph.first_arc(at.vertex) + k],
          .length_m = at.length_m + lengths_m[k],
          .vertex = next};
      if (!(reached < best_[next])) continue;
      best_[next] = reached;
      previous_[next] = at.vertex;
      open_.push_back(reached);
      std::push_heap(open_.begin(), open_.end(), std::greater<>());
    }
  }
  std::vector<int>& way = ways_[belief.robot];
  way.assign(1, goal);
  while (way.back() != belief.vertex) way.push_back(previous_[way.back()]);
}

}  // namespace ronda
