#pragma once
// Adaptive Heuristic-based Patrolling Algorithm, AHPA (Goeckner, Li, Wei & Zhu 2024): each robot
// has a cell of the map and goes round in it; when a robot is lost or joins, the map is divided
// anew.
//
// Cells are those of Voronoi by shortest-path length: a vertex belongs to the nearest robot's
// place, the lower number of equally near ones. Within a cell the robot follows a tour of
// Christofides (common/world/christofides.h) on shortest-path lengths, from stop to stop by
// shortest paths of the whole map, so it may pass through other cells. It begins where it is.
//
// The first plan is made from the starts of all robots. A robot whose plan is not for those on
// patrol makes a new one from the places it knows: its own vertex, the vertex that another heads
// to, and where that is unknown the place of the plan before. It says so with its decision, and
// who hears of a newer plan takes it: a team that hears everything has one plan at any time.
//
// Choices. Robots of the same place share its cell: the k-th of m begins k/m of the stops further
// on. In a cell of one vertex a robot stays put where that is legal, else it goes to and fro on the
// shortest edge. No randomness but the starts.
//
// A decision is O(N), a plan O(N·V) and the tours.
#include <cstdint>
#include <memory>
#include <vector>

#include "common/world/strategies/strategy.h"

namespace ronda {

class PatrolOfCells final : public Strategy {
 public:
  /// `paths` are those of the graph; they must outlive the strategy.
  PatrolOfCells(const PatrolGraph& /*graph*/, const ShortestPaths& paths) : paths_(&paths) {}

  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  Knowledge knowledge() const override { return {.intentions = true, .messages = true}; }
  int Decide(const Belief& belief, Rng& rng) override;
  void Hear(int receiver, int sender) override;

 private:
  struct Plan {
    double made_s = -1.0;
    std::vector<std::uint8_t> team;       // (N) 1 for each robot that takes part
    std::vector<int> places;              // (N) of all, also those that do not
    std::vector<std::vector<int>> tours;  // (N) stops, the first one first; empty: takes no part
  };

  std::shared_ptr<const Plan> MakePlan(double made_s, std::vector<std::uint8_t> team,
                                       std::vector<int> places) const;
  std::vector<int> TourFrom(int place, std::vector<int> cell) const;
  static void ShareTour(Plan& plan, std::size_t owner, const std::vector<int>& tour);
  std::vector<int> PlacesNow(const Belief& belief) const;
  void Follow(int robot, std::shared_ptr<const Plan> plan);

  const ShortestPaths* paths_;
  std::vector<std::shared_ptr<const Plan>> plans_;  // (N)
  std::vector<std::size_t> stops_;                  // (N) the one that the robot goes to
};

}  // namespace ronda
