#include "common/world/strategies/dtap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace ronda {

AuctionAssignment::AuctionAssignment(const PatrolGraph& graph, const ShortestPaths& paths)
    : paths_(&paths), vertices_(static_cast<std::size_t>(graph.vertex_count())) {
  constexpr std::uint16_t kUnknown = 0xffff;  // a path has fewer than kMaxVertices edges
  hops_.assign(vertices_ * vertices_, kUnknown);
  std::vector<int> path;
  for (int to = 0; to < graph.vertex_count(); ++to) {
    hops(to, to) = 0;
    for (int from = 0; from < graph.vertex_count(); ++from) {
      int at = from;
      for (; hops(at, to) == kUnknown; at = paths.next_hop(at, to)) path.push_back(at);
      for (std::uint16_t count = hops(at, to); !path.empty(); path.pop_back()) {
        hops(path.back(), to) = ++count;
      }
    }
  }
}

std::vector<RobotStart> AuctionAssignment::Begin(const PatrolGraph& graph,
                                                 std::span<const double> speeds_mps, Rng& rng) {
  const auto starts = Strategy::Begin(graph, speeds_mps, rng);
  robots_ = starts.size();
  idleness_.Begin(graph, starts, 2.0 * graph.vertex_count());
  bids_.assign(robots_ * vertices_, Bid{});
  goals_.assign(robots_ * robots_, Goals{});
  made_.assign(robots_, {});
  return starts;
}

int AuctionAssignment::Decide(const Belief& belief, Rng& rng) {
  const int robot = belief.robot;
  Goals& own = goals(robot, robot);
  made_[robot].clear();
  if (belief.previous_vertex < 0) own = {};
  if (own.next < 0 || own.next == belief.vertex) {
    own.next = own.after >= 0 ? own.after : PlanGoal(belief, belief.vertex, rng);
    own.after = PlanGoal(belief, own.next, rng);
  }
  return paths_->next_hop(belief.vertex, own.next);
}

void AuctionAssignment::Hear(int receiver, int sender) {
  goals(receiver, sender) = goals(sender, sender);
  for (const MadeBid& made : made_[sender]) bids(receiver)[made.vertex] = made.bid;
}

int AuctionAssignment::PlanGoal(const Belief& belief, int from, Rng& rng) {
  RankCandidates(belief, from, rng);
  for (const Candidate& candidate : candidates_) {
    const int vertex = candidate.vertex;
    if (Wins(belief, vertex, from)) return vertex;
    if (hops(from, vertex) == 1 && idleness_.idleness_s(belief, vertex) > high_s_ &&
        !IsGoalOfAnother(belief, vertex)) {
      return vertex;
    }
  }
  return candidates_.empty() ? belief.vertex : candidates_.front().vertex;
}

void AuctionAssignment::RankCandidates(const Belief& belief, int from, Rng& rng) {
  candidates_.clear();
  double sum_s = 0.0;
  double sum_s2 = 0.0;
  for (int vertex = 0; vertex < static_cast<int>(vertices_); ++vertex) {
    const double idleness_s = idleness_.idleness_s(belief, vertex);
    sum_s += idleness_s;
    sum_s2 += idleness_s * idleness_s;
    if (vertex == from || vertex == belief.vertex) continue;
    const double hops_to = hops(from, vertex);
    candidates_.push_back({.utility_s = idleness_s - 2.0 * hops_to * static_cast<double>(vertices_),
                           .draw = rng.Below(1u << 31),
                           .vertex = vertex});
  }
  std::ranges::sort(candidates_, std::greater<>(), [](const Candidate& candidate) {
    return std::tuple(candidate.utility_s, candidate.draw);
  });
  const double mean_s = sum_s / static_cast<double>(vertices_);
  const double variance_s2 = sum_s2 / static_cast<double>(vertices_) - mean_s * mean_s;
  high_s_ = mean_s + 2.0 * std::sqrt(std::max(0.0, variance_s2));
}

bool AuctionAssignment::Wins(const Belief& belief, int vertex, int from) {
  if (IsGoalOfAnother(belief, vertex)) return false;
  const int robot = belief.robot;
  Bid& last = bids(robot)[vertex];
  const bool won_by_another =
      last.holder >= 0 && last.holder != robot && belief.on_patrol[last.holder] != 0;
  const double own_m = OwnBid_m(robot, vertex, from);
  if (won_by_another && last.value_m <= own_m) return false;
  last = {.value_m = own_m, .holder = robot};
  made_[robot].push_back({.vertex = vertex, .bid = last});
  return true;
}

bool AuctionAssignment::IsGoalOfAnother(const Belief& belief, int vertex) {
  for (int other = 0; other < belief.robot_count(); ++other) {
    if (other != belief.robot && belief.on_patrol[other] != 0 &&
        goals(belief.robot, other).contain(vertex)) {
      return true;
    }
  }
  return false;
}

double AuctionAssignment::OwnBid_m(int robot, int vertex, int from) {
  tasks_.clear();
  for (int task = 0; task < static_cast<int>(vertices_); ++task) {
    if (bids(robot)[task].holder == robot) tasks_.push_back(task);
  }
  int centre = from;
  double least_m = kNever_s;
  for (const int task : tasks_) {
    double sum_m = 0.0;
    for (const int other : tasks_) sum_m += paths_->distance_m(task, other);
    if (sum_m < least_m) {
      least_m = sum_m;
      centre = task;
    }
  }
  return paths_->distance_m(vertex, centre) * (static_cast<double>(tasks_.size()) + 1.0);
}

}  // namespace ronda
