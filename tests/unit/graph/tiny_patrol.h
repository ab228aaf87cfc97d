#pragma once
// The best that any team can do on a tiny graph, by looking at all that it can do.
//
// Robots of 1 m/s start on vertices at once and edges are a whole number of metres, so all that
// happens, happens at whole seconds. States are those of robots and idle times; the least worst
// idleness is the smallest for which the team can go on for ever, the least average is the minimum
// mean cycle (Karp 1978) among states that are idle for at most `most_idle_s`.
#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "common/world/patrol_graph.h"

namespace ronda::testing {

struct TinyPatrol {
  int robots = 1;
  bool staying = false;
};

class TinyOptimum {
 public:
  /// Every state in which no vertex is idle for longer and the team can go on for ever.
  TinyOptimum(const PatrolGraph& graph, const TinyPatrol& patrol, int most_idle_s)
      : graph_(graph), patrol_(patrol), most_idle_s_(most_idle_s) {
    AddStarts(std::vector<Robot>());
    for (std::size_t s = 0; s < states_.size(); ++s) AddSteps(states_[s], static_cast<int>(s));
    DropDeadEnds();
  }

  /// The least largest weighted idleness.
  double wi_s() const {
    TinyOptimum rest = *this;
    double least_s = std::numeric_limits<double>::infinity();
    // Take the worst steps out until the team cannot go on.
    while (!rest.steps_.empty()) {
      least_s = 0.0;
      for (const Step& step : rest.steps_) least_s = std::max(least_s, step.worst_s);
      std::erase_if(rest.steps_, [&](const Step& step) { return step.worst_s >= least_s; });
      rest.DropDeadEnds();
    }
    return least_s;
  }

  /// The least mean over vertices and time of the weighted idleness: min over states v of the max
  /// over k of (D_n(v) − D_k(v)) / (n − k), D_k(v) the cheapest k steps that end in v.
  double agi_s() const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const std::size_t count = states_.size();
    std::vector<std::vector<double>> cheapest(count + 1, std::vector<double>(count, kNone));
    cheapest[0].assign(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      for (const Step& step : steps_) {
        double& to = cheapest[k + 1][step.to];
        to = std::min(to, cheapest[k][step.from] + step.mean_s);
      }
    }
    double least_s = kNone;
    for (std::size_t v = 0; v < count; ++v) {
      if (cheapest[count][v] == kNone) continue;
      double most_s = -kNone;
      for (std::size_t k = 0; k < count; ++k) {
        most_s = std::max(most_s, (cheapest[count][v] - cheapest[k][v]) / double(count - k));
      }
      least_s = std::min(least_s, most_s);
    }
    return least_s;
  }

 private:
  struct Robot {
    int vertex = 0;  // where it is, or will be in left_s
    int left_s = 0;
    auto operator<=>(const Robot&) const = default;
  };
  struct State {
    std::vector<Robot> robots;  // ascending: who is who does not matter
    std::vector<int> idle_s;    // (V)
    auto operator<=>(const State&) const = default;
  };
  struct Step {
    int from = 0;
    int to = 0;
    double mean_s = 0.0;   // over vertices, of this second
    double worst_s = 0.0;  // at its end, before visits
  };

  int Number(State state) {
    std::sort(state.robots.begin(), state.robots.end());
    const auto [at, is_new] = numbers_.emplace(state, static_cast<int>(states_.size()));
    if (is_new) states_.push_back(state);
    return at->second;
  }

  void AddStarts(std::vector<Robot> robots) {
    if (static_cast<int>(robots.size()) == patrol_.robots) {
      Number({.robots = robots, .idle_s = std::vector<int>(graph_.vertex_count(), 0)});
      return;
    }
    for (int v = robots.empty() ? 0 : robots.back().vertex; v < graph_.vertex_count(); ++v) {
      robots.push_back({.vertex = v});
      AddStarts(robots);
      robots.pop_back();
    }
  }

  void AddSteps(const State& from, int number) {
    Choose(from, number, 0, std::vector<bool>(graph_.vertex_count(), false), from);
  }

  /// What each robot from `robot` on may do; `to` is where the others are a second later, `stood`
  /// at which vertices they stay.
  void Choose(State from, int number, std::size_t robot, std::vector<bool> stood, State to) {
    if (robot == from.robots.size()) {
      Finish(from, number, stood, to);
      return;
    }
    const auto [vertex, left_s] = from.robots[robot];
    if (left_s > 0) {
      to.robots[robot] = {.vertex = vertex, .left_s = left_s - 1};
      Choose(from, number, robot + 1, stood, to);
      return;
    }
    for (int k = 0; k < graph_.degree(vertex); ++k) {
      to.robots[robot] = {.vertex = graph_.neighbours(vertex)[k],
                          .left_s = static_cast<int>(graph_.lengths_m(vertex)[k]) - 1};
      Choose(from, number, robot + 1, stood, to);
    }
    if (patrol_.staying) {
      to.robots[robot] = {.vertex = vertex};
      stood[vertex] = true;
      Choose(from, number, robot + 1, stood, to);
    }
  }

  void Finish(const State& from, int number, const std::vector<bool>& stood, State to) {
    Step step{.from = number};
    for (int v = 0; v < graph_.vertex_count(); ++v) {
      const double weight = graph_.weights()[v];
      to.idle_s[v] = stood[v] ? 0 : from.idle_s[v] + 1;
      step.worst_s = std::max(step.worst_s, weight * to.idle_s[v]);
      if (!stood[v]) step.mean_s += weight * (from.idle_s[v] + 0.5) / graph_.vertex_count();
      if (to.idle_s[v] > most_idle_s_) return;
    }
    for (const Robot& robot : to.robots) {
      if (robot.left_s == 0) to.idle_s[robot.vertex] = 0;
    }
    step.to = Number(to);
    steps_.push_back(step);
  }

  void DropDeadEnds() {
    for (std::size_t before = 0; before != steps_.size();) {
      before = steps_.size();
      std::vector<bool> goes_on(states_.size(), false);
      for (const Step& step : steps_) goes_on[step.from] = true;
      std::erase_if(steps_, [&](const Step& step) { return !goes_on[step.to]; });
    }
  }

  const PatrolGraph& graph_;
  TinyPatrol patrol_;
  int most_idle_s_;
  std::vector<State> states_;
  std::map<State, int> numbers_;
  std::vector<Step> steps_;
};

}  // namespace ronda::testing
