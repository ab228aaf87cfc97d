#pragma once
// What one robot knows at the moment when it must decide.
//
// This is all that a strategy or an observation can read of the patrolled world, so a robot acts on
// its own information: what it has visited, seen and been told (team_beliefs.h). The parts that its
// Knowledge does not give are empty, and reading them is a bug. With complete communication they
// are the world's own arrays, so a belief costs nothing; it is valid until the world's next event.
// Idleness is weighted by the vertices' priorities. Thread-compatible. Source: thesis §3.1.2.
#include <algorithm>
#include <cstdint>
#include <span>

#include "common/world/patrol_graph.h"
#include "common/world/world_options.h"

namespace ronda {

/// What a strategy makes use of.
struct Knowledge {
  enum class Visits { kNone, kOwn, kShared };

  Visits visits = Visits::kNone;
  bool intentions = false;  // where the others go, and when they will be there
  bool messages = false;    // what else the others say, through Strategy::Hear
};

struct Belief {
  const PatrolGraph* graph = nullptr;
  double time_s = 0.0;
  int robot = 0;
  int vertex = 0;            // where it stands, and which it has just visited
  int previous_vertex = -1;  // where it came from; −1 before its first move
  double stay_s = 0.0;       // how long staying put lasts; 0: it is not legal

  std::span<const double> speeds_mps;           // (N)
  std::span<const std::uint8_t> on_patrol;      // (N) 0: has failed, or not joined yet
  std::span<const double> last_visits_s;        // (V) later than now where a robot stays until then
  std::span<const int> targets;                 // (N) −1: unknown
  std::span<const int> previous_vertices;       // (N) where they come from; −1: unknown
  std::span<const double> expected_arrivals_s;  // (N) as announced, perhaps overdue

  int robot_count() const { return static_cast<int>(speeds_mps.size()); }
  int team_size() const {  // of those on patrol
    return static_cast<int>(std::count(on_patrol.begin(), on_patrol.end(), 1));
  }
  double last_visit_s(int of_vertex) const { return last_visits_s[of_vertex]; }
  /// How idle `of_vertex` will be at `at_s` if nobody comes before.
  double idleness_s(int of_vertex, double at_s) const {
    return graph->weights()[of_vertex] * std::max(0.0, at_s - last_visits_s[of_vertex]);
  }
  double idleness_s(int of_vertex) const { return idleness_s(of_vertex, time_s); }

  /// How long this robot takes for `length_m` without noise.
  double travel_time_s(double length_m) const {
    return RoundedDuration_s(length_m * (1.0 / speeds_mps[robot]));  // as the world rounds
  }

  int target(int other) const { return targets[other]; }
  /// Another robot is known to head to `to_vertex`, or to stand there.
  bool claimed(int to_vertex) const { return claims(to_vertex) > 0; }
  /// How many others are known to head there.
  int claims(int to_vertex) const {
    int count = 0;
    for (int other = 0; other < robot_count(); ++other) {
      count += static_cast<int>(other != robot && targets[other] == to_vertex);
    }
    return count;
  }
  /// When the other robot is expected at its target: not before now.
  double arrival_s(int other) const { return std::max(time_s, expected_arrivals_s[other]); }
};

}  // namespace ronda
