#pragma once
// The patrolled world: robots move along edges, a visit resets a vertex's idleness, time is
// continuous and event-driven.
//
// A robot is asked for an action only when it has arrived (restrained action swap, thesis §4.2).
// Simultaneous arrivals are processed robot by robot in index order, each with its visit *and* its
// decision before the next one's visit; until then the others still count as heading to their
// targets. Times are multiples of 2^-30 s, so sums of travel times are exact (below 2^23 s) and
// "simultaneous" does not depend on the order of additions.
//
//   world.Reset(starts, rng);
//   world.Schedule(changes);                       // where robots fail or join
//   while (const auto arrival = world.NextArrival(until_s))
//     world.Depart(arrival->robot, next_vertex);
//   world.AdvanceTo(until_s);
//
// Idleness is weighted by the vertices' priorities (PatrolGraph::weights, all 1 by default). A
// robot that stays put (where that is legal) keeps its vertex at idleness 0 for so long.
//
// AGI and WI over [BeginMeasurement, now] are exact (piecewise linear integrals at the events). No
// allocation after the first Reset. O(N) an event. Thread-compatible; copyable (a copy is an
// independent world in the same state). Source: thesis §1.2, §1.3, §4.2.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/base/check.h"
#include "common/base/rng.h"
#include "common/world/patrol_graph.h"
#include "common/world/world_options.h"

namespace ronda {

class PatrolWorld {
 public:
  /// `graph` must outlive the world.
  /// At least one robot, speeds positive and finite, noise and stay not negative and finite; else
  /// InputError.
  PatrolWorld(const PatrolGraph& graph, const WorldOptions& options);

  /// Time 0, idleness 0 everywhere; the robots' starts (N of them) will be the first arrivals.
  /// `rng` draws the travel noise.
  void Reset(std::span<const RobotStart> starts, const Rng& rng);

  /// Right after Reset: `vertex` was last visited at `time_s` ≤ 0, so the world starts idle.
  void SetLastVisit(int vertex, double time_s);

  /// Right after Reset: robots fail and join at given times, ascending; one whose first change is
  /// to join is absent until then. Each change must be one: who is there fails, who is not joins.
  void Schedule(std::span<const RobotChange> changes);

  /// Starts for N robots: uniform, distinct while N ≤ V (then every vertex once before any twice).
  static std::vector<RobotStart> RandomStarts(const PatrolGraph& graph, int robots, Rng& rng);

  /// The next arrival, at or before `until_s`; nullopt when there is none (time then stays at the
  /// last event). Every arrival must be followed by Depart for that robot before the next call.
  std::optional<Arrival> NextArrival(double until_s);
  /// To a neighbour of where it stands, or that vertex itself where staying is legal; else a bug.
  void Depart(int robot, int next_vertex);

  /// Instead of NextArrival, where robots are real: `robot` says that it is at `vertex` at `time_s`
  /// ≥ the clock. Others that should have arrived by then are expected at any moment.
  Arrival Arrive(int robot, int vertex, double time_s);

  /// Moves the clock on with no event in between (none may be pending before `time_s`): closes the
  /// window of measurement.
  void AdvanceTo(double time_s);

  /// Metrics count from now on (the clock stands at the beginning of the window).
  void BeginMeasurement();

  const PatrolGraph& graph() const { return *graph_; }
  int robot_count() const { return static_cast<int>(target_.size()); }
  double time_s() const { return time_s_; }
  double stay_s() const { return stay_s_; }
  double last_visit_s(int vertex) const { return last_visit_s_[vertex]; }
  std::span<const double> last_visits_s() const { return last_visit_s_; }
  double idleness_s(int vertex) const {
    return graph_->weights()[vertex] * std::max(0.0, time_s_ - last_visit_s_[vertex]);
  }
  /// 1 for each robot that is there, 0 where it has failed or has not joined.
  std::span<const std::uint8_t> on_patrol() const { return on_patrol_; }
  /// Where the robot goes (while it waits for its action: stands; −1: it is not there), when it
  /// will be there, and the vertex that it left.
  int target(int robot) const { return target_[robot]; }
  double arrival_s(int robot) const { return arrival_s_[robot]; }
  int previous_vertex(int robot) const { return previous_[robot]; }  // −1 before its first move
  std::span<const int> targets() const { return target_; }
  std::span<const int> previous_vertices() const { return previous_; }
  /// When each robot announced that it would arrive: as arrival_s, but for the noise. ∞ where it is
  /// not there.
  std::span<const double> expected_arrivals_s() const { return expected_arrival_s_; }
  /// Where the robot is: on its way from the vertex that it left.
  Position position(int robot) const;
  double speed_mps(int robot) const { return speed_mps_[robot]; }
  std::span<const double> speeds_mps() const { return speed_mps_; }
  double total_speed_mps() const { return total_speed_mps_; }
  /// How long the robot takes for `length_m` without noise; what a team announces and expects.
  double travel_time_s(int robot, double length_m) const {
    return RoundedDuration_s(length_m * pace_spm_[robot]);
  }

  /// Over [BeginMeasurement, now], open intervals included; s.
  double average_graph_idleness_s() const;
  double worst_idleness_s() const;
  /// At this moment: mean and maximum over the vertices; s.
  double instantaneous_graph_idleness_s() const;
  double instantaneous_worst_idleness_s() const;

 private:
  /// ∫ idleness of `vertex` since its last visit or the beginning of the window, up to now; s².
  double OpenIntegral_s2(int vertex) const {
    const double idle_s = std::max(0.0, time_s_ - last_visit_s_[vertex]);
    const double before_s = std::max(0.0, measure_from_s_ - last_visit_s_[vertex]);
    return 0.5 * graph_->weights()[vertex] * (idle_s * idle_s - before_s * before_s);
  }
  double NoiseFactor();
  void Stay(int robot);
  void Remove(int robot);
  /// Puts a robot where it starts.
  void Place(int robot);
  void Apply(const RobotChange& change);
  std::optional<Arrival> NextArrivalAfterChanges(double until_s);
  /// `robot` is where it went, at `time_s`.
  Arrival Visit(int robot, double time_s);

  const PatrolGraph* graph_;
  double travel_noise_;
  double stay_s_;
  double total_speed_mps_ = 0.0;
  Rng rng_{0};
  double time_s_ = 0.0;
  double measure_from_s_ = 0.0;
  double idleness_integral_s2_ = 0.0;  // closed intervals since measure_from_s_
  double worst_closed_s_ = 0.0;
  int waiting_ = -1;               // the robot that NextArrival returned and that has not departed
  std::vector<double> speed_mps_;  // (N)
  std::vector<double> pace_spm_;   // (N) seconds per metre
  std::vector<int> target_;        // (N)
  std::vector<int> previous_;      // (N)
  std::vector<double> departure_s_;         // (N)
  std::vector<double> arrival_s_;           // (N) ∞: not there
  std::vector<double> expected_arrival_s_;  // (N)
  std::vector<std::uint8_t> on_patrol_;     // (N)
  std::vector<RobotStart> starts_;          // (N)
  std::vector<RobotChange> changes_;        // those to come, the next one last
  double next_change_s_ = 0.0;              // ∞: none
  std::vector<double> last_visit_s_;        // (V)
};

inline std::optional<Arrival> PatrolWorld::NextArrival(double until_s) {
  RONDA_CHECK(waiting_ < 0, "robot {} waits for its next vertex", waiting_);
  int robot = 0;  // the earliest, the lowest index among equals
  double earliest_s = arrival_s_[0];
  for (int other = 1; other < robot_count(); ++other) {
    if (arrival_s_[other] < earliest_s) {
      earliest_s = arrival_s_[other];
      robot = other;
    }
  }
  if (next_change_s_ <= std::min(earliest_s, until_s)) return NextArrivalAfterChanges(until_s);
  if (earliest_s > until_s || earliest_s == kNever_s) return std::nullopt;
  return Visit(robot, earliest_s);
}

inline Arrival PatrolWorld::Visit(int robot, double time_s) {
  time_s_ = time_s;
  waiting_ = robot;
  const int vertex = target_[robot];
  const double idle_s = idleness_s(vertex);
  idleness_integral_s2_ += OpenIntegral_s2(vertex);
  worst_closed_s_ = std::max(worst_closed_s_, idle_s);
  last_visit_s_[vertex] = std::max(time_s_, last_visit_s_[vertex]);
  return Arrival{.robot = robot, .vertex = vertex, .time_s = time_s_, .idleness_s = idle_s};
}

inline void PatrolWorld::Depart(int robot, int next_vertex) {
  RONDA_CHECK(robot == waiting_, "robot {} does not wait for its next vertex", robot);
  const int vertex = target_[robot];
  waiting_ = -1;
  previous_[robot] = vertex;
  target_[robot] = next_vertex;
  departure_s_[robot] = time_s_;
  if (next_vertex == vertex) {
    Stay(robot);
    return;
  }
  const double duration_s = graph_->edge_length_m(vertex, next_vertex) * pace_spm_[robot];
  expected_arrival_s_[robot] = time_s_ + RoundedDuration_s(duration_s);
  arrival_s_[robot] = travel_noise_ > 0.0 ? time_s_ + RoundedDuration_s(duration_s * NoiseFactor())
                                          : expected_arrival_s_[robot];
}

}  // namespace ronda
