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
//   while (const auto arrival = world.NextArrival(until_s))
//     world.Depart(arrival->robot, next_vertex);
//   world.AdvanceTo(until_s);
//
// AGI and WI over [BeginMeasurement, now] are exact (piecewise linear integrals at the events). No
// allocation after the first Reset. O(N) an event. Thread-compatible; copyable (a copy is an
// independent world in the same state). Source: thesis §1.2, §1.3, §4.2.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "common/base/check.h"
#include "common/base/rng.h"
#include "common/world/patrol_graph.h"

namespace ronda {

/// Where a robot is at time 0: on `vertex`, or (remaining_m > 0) on the edge from `vertex` to
/// `next`, `remaining_m` before `next`.
struct RobotStart {
  int vertex = 0;
  int next = 0;
  double remaining_m = 0.0;
};

struct WorldOptions {
  std::vector<double> speeds_mps;  // (N), each > 0
  double travel_noise = 0.0;  // σ ≥ 0: a traversal takes length/speed · exp(σZ − σ²/2)
};

/// The resolution of time, 2^-30 s.
inline constexpr double kTimeStep_s = 0x1p-30;

/// A duration on the grid of time: rounded to the nearest multiple of kTimeStep_s, never 0.
inline double RoundedDuration_s(double duration_s) {
  return std::max(kTimeStep_s, std::nearbyint(duration_s * 0x1p30) * kTimeStep_s);
}

/// A robot has arrived and waits for its next vertex.
struct Arrival {
  int robot = 0;
  int vertex = 0;
  double time_s = 0.0;
  double idleness_s = 0.0;  // of the vertex, just before this visit reset it
};

class PatrolWorld {
 public:
  /// `graph` must outlive the world.
  /// At least one robot, speeds positive and finite, noise not negative and finite; else
  /// InputError.
  PatrolWorld(const PatrolGraph& graph, const WorldOptions& options);

  /// Time 0, idleness 0 everywhere; the robots' starts (N of them) will be the first arrivals.
  /// `rng` draws the travel noise.
  void Reset(std::span<const RobotStart> starts, const Rng& rng);

  /// Right after Reset: `vertex` was last visited at `time_s` ≤ 0, so the world starts idle.
  void SetLastVisit(int vertex, double time_s);

  /// Starts for N robots: uniform, distinct while N ≤ V (then every vertex once before any twice).
  static std::vector<RobotStart> RandomStarts(const PatrolGraph& graph, int robots, Rng& rng);

  /// The next arrival, at or before `until_s`; nullopt when there is none (time then stays at the
  /// last event). Every arrival must be followed by Depart for that robot before the next call.
  std::optional<Arrival> NextArrival(double until_s);
  void Depart(int robot, int next_vertex);  // a neighbour of where it stands; else a bug

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
  double last_visit_s(int vertex) const { return last_visit_s_[vertex]; }
  std::span<const double> last_visits_s() const { return last_visit_s_; }
  double idleness_s(int vertex) const { return time_s_ - last_visit_s_[vertex]; }
  /// Where the robot goes (or, while it waits for its action, stands), when it will be there, and
  /// the vertex that it left.
  int target(int robot) const { return target_[robot]; }
  double arrival_s(int robot) const { return arrival_s_[robot]; }
  int previous_vertex(int robot) const { return previous_[robot]; }  // −1 before its first move
  double speed_mps(int robot) const { return speed_mps_[robot]; }
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
    const double idleness_s = time_s_ - last_visit_s_[vertex];
    const double before_s = std::max(0.0, measure_from_s_ - last_visit_s_[vertex]);
    return 0.5 * (idleness_s * idleness_s - before_s * before_s);
  }
  double NoiseFactor();
  /// `robot` is where it went, at `time_s`.
  Arrival Visit(int robot, double time_s);

  const PatrolGraph* graph_;
  double travel_noise_;
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
  std::vector<double> arrival_s_;  // (N)
  std::vector<double> last_visit_s_;  // (V)
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
  if (earliest_s > until_s) return std::nullopt;
  return Visit(robot, earliest_s);
}

inline Arrival PatrolWorld::Visit(int robot, double time_s) {
  time_s_ = time_s;
  waiting_ = robot;
  const int vertex = target_[robot];
  const double idleness_s = time_s_ - last_visit_s_[vertex];
  idleness_integral_s2_ += OpenIntegral_s2(vertex);
  worst_closed_s_ = std::max(worst_closed_s_, idleness_s);
  last_visit_s_[vertex] = time_s_;
  return Arrival{.robot = robot, .vertex = vertex, .time_s = time_s_, .idleness_s = idleness_s};
}

inline void PatrolWorld::Depart(int robot, int next_vertex) {
  RONDA_CHECK(robot == waiting_, "robot {} does not wait for its next vertex", robot);
  const int vertex = target_[robot];
  double duration_s = graph_->edge_length_m(vertex, next_vertex) * pace_spm_[robot];
  if (travel_noise_ > 0.0) duration_s *= NoiseFactor();
  previous_[robot] = vertex;
  target_[robot] = next_vertex;
  arrival_s_[robot] = time_s_ + RoundedDuration_s(duration_s);
  waiting_ = -1;
}

}  // namespace ronda
