#pragma once
// Dynamic Task Assignment, Greedy, DTAG (Farinelli, Iocchi & Nardi 2017): each robot takes the
// vertex, anywhere, that is worth most to it, and that no other has taken.
//
// Goal: argmax over all v ≠ here of I_v − 0.75·D_v − 5·‖x_v − x_start‖, I_v the idleness in
// seconds, D_v the shortest-path length in the map's px, the last term the distance in metres from
// where the robot started, as the crow flies. A vertex that nobody has visited counts as idle since
// −100 s. Never the goal of another robot on patrol, unless all are. The robot goes there by a
// shortest path, and chooses again when it is there (or has joined again).
//
// A robot knows everyone's visits, and the goals that others say with each of their decisions (the
// newest heard counts until a newer one is). Ties at random. A new goal costs O(N + V), every other
// decision O(1); O(N²) memory.
#include <cstdint>
#include <vector>

#include "common/world/strategies/initial_idleness.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

class GreedyAssignment final : public Strategy {
 public:
  /// `paths` are those of the graph; they must outlive the strategy.
  GreedyAssignment(const PatrolGraph& /*graph*/, const ShortestPaths& paths) : paths_(&paths) {}

  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .messages = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;
  void Hear(int receiver, int sender) override;

 private:
  /// The goal of `other` as `robot` knows it.
  int& goal(int robot, int other) { return goals_[starts_.size() * robot + other]; }
  void FindFree(const Belief& belief);
  int ChooseGoal(const Belief& belief, Rng& rng);

  const ShortestPaths* paths_;
  std::vector<RobotStart> starts_;  // (N)
  InitialIdleness idleness_;
  std::vector<int> goals_;          // (N, N) −1: none known
  std::vector<std::uint8_t> free_;  // (V) scratch: the vertices to choose from
};

}  // namespace ronda
