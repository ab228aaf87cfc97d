#include "common/world/strategies/ahpa.h"

#include <algorithm>
#include <utility>

#include "common/world/christofides.h"

namespace ronda {
namespace {

int NearestNeighbour(const PatrolGraph& graph, int vertex) {
  const auto lengths_m = graph.lengths_m(vertex);
  return graph.neighbours(vertex)[std::ranges::min_element(lengths_m) - lengths_m.begin()];
}

}  // namespace

std::vector<RobotStart> PatrolOfCells::Begin(const PatrolGraph& graph,
                                             std::span<const double> speeds_mps, Rng& rng) {
  const auto starts = Strategy::Begin(graph, speeds_mps, rng);
  std::vector<int> places;
  for (const RobotStart& start : starts) places.push_back(start.vertex);
  const std::vector<std::uint8_t> everyone(starts.size(), 1);
  plans_.assign(starts.size(), MakePlan(-1.0, everyone, places));
  stops_.assign(starts.size(), 0);
  return starts;
}

int PatrolOfCells::Decide(const Belief& belief, Rng& /*rng*/) {
  const int robot = belief.robot;
  if (!std::ranges::equal(plans_[robot]->team, belief.on_patrol)) {
    Follow(robot, MakePlan(belief.time_s, {belief.on_patrol.begin(), belief.on_patrol.end()},
                           PlacesNow(belief)));
  }
  const std::vector<int>& tour = plans_[robot]->tours[robot];
  std::size_t& stop = stops_[robot];
  if (tour[stop] == belief.vertex) stop = (stop + 1) % tour.size();
  if (tour[stop] != belief.vertex) return paths_->next_hop(belief.vertex, tour[stop]);
  return belief.stay_s > 0.0 ? belief.vertex : NearestNeighbour(*belief.graph, belief.vertex);
}

void PatrolOfCells::Hear(int receiver, int sender) {
  if (plans_[sender]->made_s > plans_[receiver]->made_s) Follow(receiver, plans_[sender]);
}

void PatrolOfCells::Follow(int robot, std::shared_ptr<const Plan> plan) {
  plans_[robot] = std::move(plan);
  stops_[robot] = 0;
}

std::vector<int> PatrolOfCells::PlacesNow(const Belief& belief) const {
  std::vector<int> places = plans_[belief.robot]->places;
  for (int other = 0; other < belief.robot_count(); ++other) {
    if (belief.target(other) >= 0) places[other] = belief.target(other);
  }
  places[belief.robot] = belief.vertex;
  return places;
}

std::shared_ptr<const PatrolOfCells::Plan> PatrolOfCells::MakePlan(double made_s,
                                                                  std::vector<std::uint8_t> team,
                                                                  std::vector<int> places) const {
  const int robots = static_cast<int>(places.size());
  std::vector<std::vector<int>> cells(places.size());  // of the first robot at each place
  for (int robot = 0; robot < robots; ++robot) ...
}

}  // namespace ronda
