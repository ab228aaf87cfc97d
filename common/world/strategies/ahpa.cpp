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
  const std::size_t robots = places.size();
  std::vector<std::vector<int>> cells(robots);  // of the first robot of each place
  for (int vertex = 0; vertex < paths_->vertex_count(); ++vertex) {
    int owner = -1;
    for (int robot = 0; robot < static_cast<int>(robots); ++robot) {
      if (team[robot] == 0) continue;
      if (owner < 0 ||
          paths_->distance_m(places[robot], vertex) < paths_->distance_m(places[owner], vertex)) {
        owner = robot;
      }
    }
    if (owner >= 0) cells[owner].push_back(vertex);
  }
  auto plan = std::make_shared<Plan>();
  plan->made_s = made_s;
  plan->team = std::move(team);
  plan->places = std::move(places);
  plan->tours.resize(robots);
  for (std::size_t owner = 0; owner < robots; ++owner) {
    if (!cells[owner].empty()) ShareTour(*plan, owner, TourFrom(plan->places[owner], cells[owner]));
  }
  return plan;
}

std::vector<int> PatrolOfCells::TourFrom(int place, std::vector<int> cell) const {
  std::ranges::rotate(cell, std::ranges::find(cell, place));
  return ChristofidesTour(*paths_, cell);
}

void PatrolOfCells::ShareTour(Plan& plan, std::size_t owner, const std::vector<int>& tour) {
  std::vector<std::size_t> sharers;
  for (std::size_t robot = owner; robot < plan.places.size(); ++robot) {
    if (plan.team[robot] != 0 && plan.places[robot] == plan.places[owner]) sharers.push_back(robot);
  }
  for (std::size_t k = 0; k < sharers.size(); ++k) {
    auto& own = plan.tours[sharers[k]] = tour;
    std::ranges::rotate(
        own, own.begin() + static_cast<std::ptrdiff_t>(k * tour.size() / sharers.size()));
  }
}

}  // namespace ronda
