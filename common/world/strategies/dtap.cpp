#include "common/world/strategies/dtap.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/world/strategies/random_argmax.h"

namespace ronda {
static const int kMode = std::getenv("MODE") ? std::atoi(std::getenv("MODE")) : 0;

AuctionAssignment::AuctionAssignment(const PatrolGraph& graph, const ShortestPaths& paths)
    : paths_(&paths), vertices_(static_cast<std::size_t>(graph.vertex_count())) {
  hops_.resize(vertices_ * vertices_);
  for (int from = 0; from < graph.vertex_count(); ++from) {
    for (int to = 0; to < graph.vertex_count(); ++to) {
      for (int at = from; at != to; at = paths.next_hop(at, to)) ++hops_[vertices_ * from + to];
    }
  }
}

std::vector<RobotStart> AuctionAssignment::Begin(const PatrolGraph& graph,
                                                 std::span<const double> speeds_mps, Rng& rng) {
  const auto starts = Strategy::Begin(graph, speeds_mps, rng);
  idleness_.Begin(graph, starts, 2.0 * graph.vertex_count());
  bids_.assign(starts.size() * vertices_, Bid{});
  goals_.assign(starts.size(), Goals{});
  return starts;
}

int AuctionAssignment::Decide(const Belief& belief, Rng& rng) {
  Goals& goals = goals_[belief.robot];
  if (belief.previous_vertex < 0) StartAnew(belief.robot);
  if (goals.next < 0 || goals.next == belief.vertex) {
    VoidBidsOfAbsent(belief);
    goals.next = goals.after >= 0 ? goals.after : Auction(belief, belief.vertex, rng);
    if (kMode == 1) Place(belief.robot, belief.robot, goals.next, 0.0);
    goals.after = Auction(belief, goals.next, rng);
    if (kMode == 1) Place(belief.robot, belief.robot, goals.after, 0.0);
  }
  return paths_->next_hop(belief.vertex, goals.next);
}

void AuctionAssignment::StartAnew(int robot) {
  goals_[robot] = {};
  std::fill_n(bids(robot), vertices_, Bid{});
}

void AuctionAssignment::Hear(int receiver, int sender) {
  for (int v = 0; v < (int)vertices_; ++v)
    if (bids(sender)[v].holder == sender) Place(receiver, sender, v, bids(sender)[v].value_m);
}

void AuctionAssignment::Place(int robot, int bidder, int vertex, double value_m) {
  Bid& known = bids(robot)[vertex];
  if (value_m < known.value_m) known = {.value_m = value_m, .holder = bidder};
}

void AuctionAssignment::VoidBidsOfAbsent(const Belief& belief) {
  for (Bid* bid = bids(belief.robot); bid != bids(belief.robot) + vertices_; ++bid) {
    if (bid->holder >= 0 && belief.on_patrol[bid->holder] == 0) *bid = {};
  }
}

int AuctionAssignment::Centre(int robot, int from) {
  tasks_.clear();
  for (int vertex = 0; vertex < static_cast<int>(vertices_); ++vertex) {
    if (bids(robot)[vertex].holder == robot) tasks_.push_back(vertex);
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
  return centre;
}

int AuctionAssignment::Auction(const Belief& belief, int from, Rng& rng) {
  const int robot = belief.robot;
  const int centre = Centre(robot, from);
  double sum_s = 0.0, sum_s2 = 0.0;
  idle_s_.resize(vertices_);
  for (int v = 0; v < (int)vertices_; ++v) {
    idle_s_[v] = idleness_.idleness_s(belief, v);
    sum_s += idle_s_[v]; sum_s2 += idle_s_[v] * idle_s_[v];
  }
  const double mean_s = sum_s / vertices_;
  const double limit_s = mean_s + 2.0 * std::sqrt(std::max(0.0, sum_s2 / vertices_ - mean_s * mean_s));
  RandomArgmax won(rng), any(rng);
  for (int v = 0; v < (int)vertices_; ++v) {
    if (v == from) continue;
    const int hops = hops_[vertices_ * from + v];
    const double utility = idle_s_[v] - 2.0 * hops * vertices_;
    double bid = paths_->distance_m(v, centre) * (tasks_.size() + 1.0);
    bool mine = bids(robot)[v].holder == robot || bid < bids(robot)[v].value_m;
    if (kMode == 2) {
      for (int o = 0; o < belief.robot_count(); ++o)
        if (o != robot && belief.on_patrol[o] && (goals_[o].next == v || goals_[o].after == v)) mine = false;
    }
    any.Offer(v, utility);
    if (mine || (hops <= 1 && idle_s_[v] > limit_s)) won.Offer(v, utility);
  }
  const int v = won.best() >= 0 ? won.best() : any.best();
  if (won.best() >= 0) Place(robot, robot, v, paths_->distance_m(v, centre) * (tasks_.size() + 1.0));
  return v;
}

}  // namespace ronda
