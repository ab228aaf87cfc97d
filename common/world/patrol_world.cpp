#include "common/world/patrol_world.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "common/base/error.h"

namespace ronda {

PatrolWorld::PatrolWorld(const PatrolGraph& graph, const WorldOptions& options)
    : graph_(&graph),
      travel_noise_(options.travel_noise),
      stay_s_(options.stay_s > 0.0 ? RoundedDuration_s(options.stay_s) : options.stay_s),
      speed_mps_(options.speeds_mps) {
  if (speed_mps_.empty()) throw InputError("a patrolled world needs at least 1 robot, got 0");
  if (!(travel_noise_ >= 0.0) || !std::isfinite(travel_noise_)) {
    throw InputError(fmt::format("travel noise must be ≥ 0 and finite, got {}", travel_noise_));
  }
  if (!(stay_s_ >= 0.0) || !std::isfinite(stay_s_)) {
    throw InputError(fmt::format("a stay must be ≥ 0 s and finite, got {}", stay_s_));
  }
  for (std::size_t robot = 0; robot < speed_mps_.size(); ++robot) {
    const double speed_mps = speed_mps_[robot];
    if (!(speed_mps > 0.0) || !std::isfinite(speed_mps)) {
      throw InputError(
          fmt::format("robot {}: a speed must be > 0 m/s and finite, got {}", robot, speed_mps));
    }
    pace_spm_.push_back(1.0 / speed_mps);
    total_speed_mps_ += speed_mps;
  }
  target_.resize(speed_mps_.size());
  previous_.resize(speed_mps_.size());
  departure_s_.resize(speed_mps_.size());
  arrival_s_.resize(speed_mps_.size());
  expected_arrival_s_.resize(speed_mps_.size());
  on_patrol_.resize(speed_mps_.size());
  last_visit_s_.resize(static_cast<std::size_t>(graph.vertex_count()));
}

void PatrolWorld::Reset(std::span<const RobotStart> starts, const Rng& rng) {
  RONDA_CHECK(starts.size() == target_.size(), "{} starts for {} robots", starts.size(),
              target_.size());
  rng_ = rng;
  time_s_ = 0.0;
  waiting_ = -1;
  std::fill(last_visit_s_.begin(), last_visit_s_.end(), 0.0);
  starts_.assign(starts.begin(), starts.end());
  changes_.clear();
  next_change_s_ = kNever_s;
  for (int robot = 0; robot < robot_count(); ++robot) {
    const RobotStart& start = starts_[robot];
    RONDA_CHECK(start.remaining_m <= 0.0 ||
                    start.remaining_m <= graph_->edge_length_m(start.vertex, start.next),
                "robot {} starts {} m before vertex {}, beyond its edge", robot, start.remaining_m,
                start.next);
    Place(robot);
  }
  BeginMeasurement();
}

void PatrolWorld::Place(int robot) {
  const RobotStart& start = starts_[robot];
  const bool on_edge = start.remaining_m > 0.0;
  target_[robot] = on_edge ? start.next : start.vertex;
  previous_[robot] = on_edge ? start.vertex : -1;
  departure_s_[robot] = time_s_;
  arrival_s_[robot] = time_s_;
  if (on_edge) {
    const double length_m = graph_->edge_length_m(start.vertex, start.next);
    departure_s_[robot] -= (length_m - start.remaining_m) * pace_spm_[robot];
    arrival_s_[robot] += travel_time_s(robot, start.remaining_m);
  }
  expected_arrival_s_[robot] = arrival_s_[robot];
  on_patrol_[robot] = 1;
}

void PatrolWorld::Schedule(std::span<const RobotChange> changes) {
  RONDA_CHECK(time_s_ == 0.0 && waiting_ < 0, "changes scheduled at {} s", time_s_);
  changes_.assign(changes.rbegin(), changes.rend());
  next_change_s_ = changes_.empty() ? kNever_s : changes_.back().time_s;
  for (const RobotChange& change : changes_) on_patrol_[change.robot] = change.joins ? 0 : 1;
  for (int robot = 0; robot < robot_count(); ++robot) {
    if (on_patrol_[robot] == 0) Remove(robot);
  }
}

void PatrolWorld::Remove(int robot) {
  on_patrol_[robot] = 0;
  target_[robot] = -1;
  previous_[robot] = -1;
  arrival_s_[robot] = kNever_s;
  expected_arrival_s_[robot] = kNever_s;
}

void PatrolWorld::Apply(const RobotChange& change) {
  RONDA_CHECK((on_patrol_[change.robot] == 0) == change.joins, "robot {} {} at {} s", change.robot,
              change.joins ? "joins, but is there" : "fails, but is not there", change.time_s);
  time_s_ = change.time_s;
  if (change.joins) {
    Place(change.robot);
    return;
  }
  const int vertex = target_[change.robot];  // a stay ends here
  last_visit_s_[vertex] = std::min(last_visit_s_[vertex], time_s_);
  Remove(change.robot);
}

std::optional<Arrival> PatrolWorld::NextArrivalAfterChanges(double until_s) {
  Apply(changes_.back());
  changes_.pop_back();
  next_change_s_ = changes_.empty() ? kNever_s : changes_.back().time_s;
  return NextArrival(until_s);
}

void PatrolWorld::Stay(int robot) {
  RONDA_CHECK(stay_s_ > 0.0, "robot {} stays put, which is not legal here", robot);
  arrival_s_[robot] = time_s_ + stay_s_;
  expected_arrival_s_[robot] = arrival_s_[robot];
  last_visit_s_[target_[robot]] = std::max(last_visit_s_[target_[robot]], arrival_s_[robot]);
}

Position PatrolWorld::position(int robot) const {
  const Position& ahead = graph_->positions()[target_[robot]];
  if (previous_[robot] < 0 || arrival_s_[robot] <= time_s_) return ahead;
  const Position& behind = graph_->positions()[previous_[robot]];
  const double left =
      (arrival_s_[robot] - time_s_) / (arrival_s_[robot] - departure_s_[robot]);  // share
  return {.x_m = left * behind.x_m + (1.0 - left) * ahead.x_m,
          .y_m = left * behind.y_m + (1.0 - left) * ahead.y_m};
}

void PatrolWorld::SetLastVisit(int vertex, double time_s) {
  RONDA_CHECK(time_s_ == 0.0 && time_s <= 0.0 && waiting_ < 0,
              "a last visit at {} s, set at {} s: only before the first event", time_s, time_s_);
  last_visit_s_[vertex] = time_s;
}

std::vector<RobotStart> PatrolWorld::RandomStarts(const PatrolGraph& graph, int robots, Rng& rng) {
  std::vector<int> order(static_cast<std::size_t>(graph.vertex_count()));
  std::vector<RobotStart> starts;
  starts.reserve(static_cast<std::size_t>(robots));
  while (static_cast<int>(starts.size()) < robots) {
    // The next part of a random order of all vertices (Fisher & Yates), begun anew after each pass.
    const auto position = static_cast<std::uint32_t>(starts.size() % order.size());
    if (position == 0) std::iota(order.begin(), order.end(), 0);
    const auto left = static_cast<std::uint32_t>(order.size()) - position;
    std::swap(order[position], order[position + rng.Below(left)]);
    starts.push_back({.vertex = order[position], .next = order[position]});
  }
  return starts;
}

Arrival PatrolWorld::Arrive(int robot, int vertex, double time_s) {
  RONDA_CHECK(waiting_ < 0, "robot {} waits for its next vertex", waiting_);
  RONDA_CHECK(time_s >= time_s_, "an arrival at {} s, before the clock's {} s", time_s, time_s_);
  target_[robot] = vertex;
  for (double& arrival_s : arrival_s_) arrival_s = std::max(arrival_s, time_s);
  arrival_s_[robot] = time_s;
  expected_arrival_s_ = arrival_s_;
  return Visit(robot, time_s);
}

void PatrolWorld::AdvanceTo(double time_s) {
  RONDA_CHECK(waiting_ < 0, "robot {} waits for its next vertex", waiting_);
  const double next_s = *std::min_element(arrival_s_.begin(), arrival_s_.end());
  RONDA_CHECK(time_s_ <= time_s && time_s <= next_s,
              "the clock can go from {} s to the next arrival at {} s, not to {} s", time_s_,
              next_s, time_s);
  time_s_ = time_s;
}

void PatrolWorld::BeginMeasurement() {
  measure_from_s_ = time_s_;
  idleness_integral_s2_ = 0.0;
  worst_closed_s_ = 0.0;
}

double PatrolWorld::NoiseFactor() {
  return std::exp(travel_noise_ * rng_.Normal() - 0.5 * travel_noise_ * travel_noise_);
}

double PatrolWorld::average_graph_idleness_s() const {
  const double window_s = time_s_ - measure_from_s_;
  RONDA_CHECK(window_s > 0.0, "a mean over a window of {} s", window_s);
  double integral_s2 = idleness_integral_s2_;
  for (int vertex = 0; vertex < graph_->vertex_count(); ++vertex) {
    integral_s2 += OpenIntegral_s2(vertex);
  }
  return integral_s2 / (window_s * graph_->vertex_count());
}

double PatrolWorld::worst_idleness_s() const {
  return std::max(worst_closed_s_, instantaneous_worst_idleness_s());
}

double PatrolWorld::instantaneous_graph_idleness_s() const {
  double sum_s = 0.0;
  for (int vertex = 0; vertex < graph_->vertex_count(); ++vertex) sum_s += idleness_s(vertex);
  return sum_s / graph_->vertex_count();
}

double PatrolWorld::instantaneous_worst_idleness_s() const {
  double worst_s = 0.0;
  for (int vertex = 0; vertex < graph_->vertex_count(); ++vertex) {
    worst_s = std::max(worst_s, idleness_s(vertex));
  }
  return worst_s;
}

}  // namespace ronda
