#pragma once
// The values of a patrolled world: who takes part, where they start, what happens, how time is
// counted.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
  double stay_s = 0.0;        // how long a robot that stays put does so; 0: not legal
};

/// At `time_s` > 0 a robot fails for good or until it joins (again), where it started.
struct RobotChange {
  double time_s = 0.0;
  int robot = 0;
  bool joins = false;

  bool operator==(const RobotChange&) const = default;
};

/// A robot has arrived and waits for its next vertex.
struct Arrival {
  int robot = 0;
  int vertex = 0;
  double time_s = 0.0;
  double idleness_s = 0.0;  // of the vertex, just before this visit reset it; weighted
};

/// Later than any event.
inline constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// The resolution of time, 2^-30 s.
inline constexpr double kTimeStep_s = 0x1p-30;

/// A duration on the grid of time: rounded to the nearest multiple of kTimeStep_s, never 0.
inline double RoundedDuration_s(double duration_s) {
  return std::max(kTimeStep_s, std::nearbyint(duration_s * 0x1p30) * kTimeStep_s);
}

}  // namespace ronda
