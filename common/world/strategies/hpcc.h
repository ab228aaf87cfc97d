#pragma once
// Heuristic Pathfinder Conscientious Cognitive, HPCC (Almeida et al. 2004): picks a vertex anywhere
// that is both near and idle, and goes there by a way that is both short and idle.
//
// Goal: argmax over all v ≠ here of (Dmax − D_v)/Dmax + I_v/Imax, D_v the shortest-path length, I_v
// the idleness, the maxima over those v. Way: least sum over its arcs of (Imax − I_j)/Imax +
// (c − cmin)/(cmax − cmin), j the arc's head, c its length, cmin and cmax over all arcs of the map
// (Dijkstra). 0/0 is 0. Goal and way are kept until the goal is reached; a robot that joins again
// starts anew. A robot knows its own visits only. Goals that tie fall at random; of ways of equal
// weight the shorter is taken (on a map of equal edges that nobody has left yet every way weighs
// 0, and without this rule a robot would wander), then the one found first.
//
// A new goal costs O(V + E log V), every other decision O(1); O(N·V) memory.
#include <vector>

#include "common/world/strategies/strategy.h"

namespace ronda {

class HeuristicPathfinder final : public Strategy {
 public:
  /// `paths` are those of `graph`; they must outlive the strategy.
  HeuristicPathfinder(const PatrolGraph& graph, const ShortestPaths& paths);

  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  Knowledge knowledge() const override { return {.visits = Knowledge::Visits::kOwn}; }
  int Decide(const Belief& belief, Rng& rng) override;

 private:
  /// The cost of the way from where the robot stands to a vertex.
  struct Cost {
    double weight = 0.0;
    double length_m = 0.0;
    int vertex = 0;

    auto operator<=>(const Cost&) const = default;
  };

  int ChooseGoal(const Belief& belief, double most_idle_s, Rng& rng) const;
  void FindWay(const Belief& belief, double most_idle_s, int goal);

  const ShortestPaths* paths_;
  std::vector<double> farthest_m_;      // (V) Dmax from there
  std::vector<double> length_share_;    // (arcs) (c − cmin)/(cmax − cmin)
  std::vector<std::vector<int>> ways_;  // (N) from the goal back to where the robot is
  std::vector<Cost> best_;              // (V) scratch of Dijkstra
  std::vector<int> previous_;           // (V)
  std::vector<Cost> open_;              // a heap
};

}  // namespace ronda
