#pragma once
// The conditions that a team patrols under, beside map and number of robots: what evaluation varies
// and training may be made hard with. The defaults are the thesis's world.
//
// Communication. After each decision a robot tells the others what it has visited, where it goes
// and when it will be there. Each of them hears it unless it is lost (independently), out of range
// (distance at that moment), or still under way (delay). Where an observation radius is given, a
// robot that decides also sees the true idleness of all vertices in that distance, and where robots
// in that distance go; a team with a radius and no other condition of communication is silent.
//
// Attrition. Robots fail and join at given times, or fail at a rate and are back after a repair.
// The last robot on patrol never fails at random. All know who is on patrol.
//
// Plain values; CheckConditions throws UsageError that names condition, rule and value. Source:
// thesis §1.2 (speeds), §3.1.2 (partial observation); docs/conditions.md.
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/base/rng.h"
#include "common/world/patrol_graph.h"
#include "common/world/world_options.h"

namespace ronda {

struct Communication {
  std::optional<double> message_loss = {};          // probability in [0, 1]
  std::optional<double> message_range_m = {};       // > 0; none: unlimited
  double message_delay_s = 0.0;                     // ≥ 0
  std::optional<double> observation_radius_m = {};  // ≥ 0; none: robots only hear

  bool operator==(const Communication&) const = default;
  /// Everyone knows everything at once.
  bool complete() const;
  /// The probability that a message is lost, with the silence that follows from a radius.
  double loss() const;
};

struct Attrition {
  std::vector<RobotChange> changes = {};  // at given times, in any order
  std::optional<double> mean_time_to_failure_s =
      {};                               // ≥ 1, of each robot; none: no random failures
  std::optional<double> repair_s = {};  // ≥ 1; none: who failed at random stays away

  bool operator==(const Attrition&) const = default;
};

struct Conditions {
  std::vector<double> speeds_mps{1.0};  // the robots take them in turn; each > 0
  double travel_noise = 0.0;            // as WorldOptions
  double stay_s = 0.0;                  // as WorldOptions
  Communication communication = {};
  Attrition attrition = {};
  std::vector<std::pair<std::string, double>> priorities = {};  // by vertex id, the others 1;
                                                                // empty: as the map says

  bool operator==(const Conditions&) const = default;
};

/// Throws UsageError where a value is out of its range, or robots fail that are not there.
void CheckConditions(const Conditions& conditions, int robots);

/// What differs from the defaults, in a few words for a table ("noise 0.1, loss 0.5"); else "".
std::string Label(const Conditions& conditions);

/// (robots) speeds, and their sum.
std::vector<double> SpeedsOf(const Conditions& conditions, int robots);
double TotalSpeed_mps(const Conditions& conditions, int robots);
WorldOptions WorldOptionsOf(const Conditions& conditions, int robots);

/// All changes of one episode up to `until_s`, ascending, as PatrolWorld::Schedule wants them.
std::vector<RobotChange> DrawChanges(const Attrition& attrition, int robots, double until_s,
                                     Rng rng);

/// The graph with the conditions' priorities. UsageError where a vertex is not on the map.
PatrolGraph WithPriorities(const PatrolGraph& graph, const Conditions& conditions);

}  // namespace ronda
