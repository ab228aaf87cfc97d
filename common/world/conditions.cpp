#include "common/world/conditions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/base/error.h"

namespace ronda {
namespace {

void Require(bool holds, const char* condition, const char* rule, double value) {
  if (!holds || !std::isfinite(value)) {
    throw UsageError(fmt::format("{} must be {}, got {}", condition, rule, value));
  }
}

template <class Holds>
void RequireIfGiven(const std::optional<double>& value, const char* condition, const char* rule,
                    const Holds& holds) {
  if (value) Require(holds(*value), condition, rule, *value);
}

bool Earlier(const RobotChange& a, const RobotChange& b) {
  return a.time_s != b.time_s ? a.time_s < b.time_s : a.robot < b.robot;
}

/// In the order of their times, which lie on the grid of time.
std::vector<RobotChange> Ascending(std::vector<RobotChange> changes) {
  for (RobotChange& change : changes) change.time_s = RoundedDuration_s(change.time_s);
  std::stable_sort(changes.begin(), changes.end(), Earlier);
  return changes;
}

/// Whether each robot is there at time 0: unless the first that it does is to join.
std::vector<bool> AtFirst(const std::vector<RobotChange>& ascending, int robots) {
  std::vector<bool> there(static_cast<std::size_t>(robots), true);
  for (auto change = ascending.rbegin(); change != ascending.rend(); ++change) {
    there[change->robot] = !change->joins;
  }
  return there;
}

void CheckChanges(const Attrition& attrition, int robots) {
  for (const RobotChange& change : attrition.changes) {
    Require(change.time_s > 0.0, change.joins ? "the time of a joining" : "the time of a failure",
            "> 0 s and finite", change.time_s);
    if (change.robot < 0 || change.robot >= robots) {
      throw UsageError(fmt::format("a robot that fails or joins must be in 0 … {}, got {}",
                                   robots - 1, change.robot));
    }
  }
  const auto ascending = Ascending(attrition.changes);
  std::vector<bool> there = AtFirst(ascending, robots);
  auto on_patrol = std::count(there.begin(), there.end(), true);
  if (on_patrol == 0) throw UsageError("at least one robot must be there from the beginning");
  for (const RobotChange& change : ascending) {
    if (there[change.robot] == change.joins) {
      throw UsageError(fmt::format("robot {} {} at {} s, but it is {} there then", change.robot,
                                   change.joins ? "joins" : "fails", change.time_s,
                                   change.joins ? "already" : "not"));
    }
    there[change.robot] = change.joins;
    on_patrol += change.joins ? 1 : -1;
    if (on_patrol == 0) {
      throw UsageError(fmt::format("robot {} fails at {} s, but it is the last one there",
                                   change.robot, change.time_s));
    }
  }
}

}  // namespace

bool Communication::complete() const {
  return loss() == 0.0 && !message_range_m && message_delay_s == 0.0;
}

double Communication::loss() const {
  const bool silent = observation_radius_m && !message_range_m && message_delay_s == 0.0;
  return message_loss.value_or(silent ? 1.0 : 0.0);
}

void CheckConditions(const Conditions& conditions, int robots) {
  for (const double speed_mps : conditions.speeds_mps) {
    Require(speed_mps > 0.0, "speed", "> 0 m/s and finite", speed_mps);
  }
  if (conditions.speeds_mps.empty()) throw UsageError("speed needs at least one value, got none");
  Require(conditions.travel_noise >= 0.0, "noise", "≥ 0 and finite", conditions.travel_noise);
  Require(conditions.stay_s >= 0.0, "stay", "≥ 0 s and finite", conditions.stay_s);
  const Communication& communication = conditions.communication;
  RequireIfGiven(communication.message_loss, "message loss", "in 0 … 1",
                 [](double loss) { return loss >= 0.0 && loss <= 1.0; });
  RequireIfGiven(communication.message_range_m, "message range", "> 0 m and finite",
                 [](double range_m) { return range_m > 0.0; });
  Require(communication.message_delay_s >= 0.0, "message delay", "≥ 0 s and finite",
          communication.message_delay_s);
  RequireIfGiven(communication.observation_radius_m, "observation radius", "≥ 0 m and finite",
                 [](double radius_m) { return radius_m >= 0.0; });
  const Attrition& attrition = conditions.attrition;
  const auto at_least_1_s = [](double duration_s) { return duration_s >= 1.0; };
  RequireIfGiven(attrition.mean_time_to_failure_s, "mean time to failure", "≥ 1 s and finite",
                 at_least_1_s);
  RequireIfGiven(attrition.repair_s, "repair time", "≥ 1 s and finite", at_least_1_s);
  if (attrition.repair_s && !attrition.mean_time_to_failure_s) {
    throw UsageError("a repair time needs a mean time to failure");
  }
  if (attrition.mean_time_to_failure_s && !attrition.changes.empty()) {
    throw UsageError("robots fail and join either at given times or at random, not both");
  }
  CheckChanges(attrition, robots);
}

std::string Label(const Conditions& conditions) {
  std::vector<std::string> parts;
  const auto add = [&](const char* name, const std::optional<double>& value, const char* unit) {
    if (value) parts.push_back(fmt::format("{} {:g}{}", name, *value, unit));
  };
  const auto unless_zero = [](double value) {
    return value > 0.0 ? std::optional(value) : std::nullopt;
  };
  const Communication& communication = conditions.communication;
  const Attrition& attrition = conditions.attrition;
  if (conditions.speeds_mps != Conditions().speeds_mps) {
    parts.push_back(fmt::format("speed {:g} m/s", fmt::join(conditions.speeds_mps, "/")));
  }
  add("noise", unless_zero(conditions.travel_noise), "");
  add("loss", unless_zero(communication.loss()), "");
  add("range", communication.message_range_m, " m");
  add("delay", unless_zero(communication.message_delay_s), " s");
  add("radius", communication.observation_radius_m, " m");
  add("failures each", attrition.mean_time_to_failure_s, " s");
  add("repair", attrition.repair_s, " s");
  for (const RobotChange& change : Ascending(attrition.changes)) {
    parts.push_back(
        fmt::format("{} {}@{:g} s", change.joins ? "join" : "fail", change.robot, change.time_s));
  }
  for (const auto& [vertex, priority] : conditions.priorities) {
    parts.push_back(fmt::format("priority {}={:g}", vertex, priority));
  }
  add("stay", unless_zero(conditions.stay_s), " s");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<double> SpeedsOf(const Conditions& conditions, int robots) {
  std::vector<double> speeds_mps;
  for (int robot = 0; robot < robots; ++robot) {
    speeds_mps.push_back(
        conditions.speeds_mps[static_cast<std::size_t>(robot) % conditions.speeds_mps.size()]);
  }
  return speeds_mps;
}

double TotalSpeed_mps(const Conditions& conditions, int robots) {
  const auto speeds_mps = SpeedsOf(conditions, robots);
  return std::accumulate(speeds_mps.begin(), speeds_mps.end(), 0.0);
}

WorldOptions WorldOptionsOf(const Conditions& conditions, int robots) {
  return {.speeds_mps = SpeedsOf(conditions, robots),
          .travel_noise = conditions.travel_noise,
          .stay_s = conditions.stay_s};
}

std::vector<RobotChange> DrawChanges(const Attrition& attrition, int robots, double until_s,
                                     Rng rng) {
  if (!attrition.mean_time_to_failure_s) return Ascending(attrition.changes);
  const auto lifetime_s = [&] {
    return RoundedDuration_s(-*attrition.mean_time_to_failure_s * std::log1p(-rng.Uniform()));
  };
  const double away_s = attrition.repair_s ? RoundedDuration_s(*attrition.repair_s) : kNever_s;
  std::vector<RobotChange> next;  // of each robot
  for (int robot = 0; robot < robots; ++robot) {
    next.push_back({.time_s = lifetime_s(), .robot = robot});
  }
  std::vector<RobotChange> drawn;
  int on_patrol = robots;
  while (true) {
    RobotChange& change = *std::min_element(next.begin(), next.end(), Earlier);
    if (!(change.time_s < until_s)) return drawn;
    if (change.joins || on_patrol > 1) {
      drawn.push_back(change);
      on_patrol += change.joins ? 1 : -1;
      change.joins = !change.joins;
    }
    change.time_s += change.joins ? away_s : lifetime_s();
  }
}

PatrolGraph WithPriorities(const PatrolGraph& graph, const Conditions& conditions) {
  if (conditions.priorities.empty()) return graph;
  GraphData data = graph.data();
  data.priorities.assign(data.positions.size(), 1.0);
  for (const auto& [id, priority] : conditions.priorities) {
    const auto found = std::find(data.vertex_ids.begin(), data.vertex_ids.end(), id);
    if (found == data.vertex_ids.end()) {
      throw UsageError(fmt::format("priority: map {} has no vertex {}", graph.name(), id));
    }
    if (!IsPriority(priority)) {
      throw UsageError(
          fmt::format("priority of vertex {} must be in 1e-6 … 1e6, got {}", id, priority));
    }
    data.priorities[static_cast<std::size_t>(found - data.vertex_ids.begin())] = priority;
  }
  return PatrolGraph(std::move(data));
}

}  // namespace ronda
