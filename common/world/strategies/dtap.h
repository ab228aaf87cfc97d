#pragma once
// Dynamic Task Assignment by sequential single-item auction, DTAP (Farinelli, Iocchi & Nardi 2017):
// robots bid for the vertices, so that each comes to tend those about the middle of its own.
//
// A robot at its goal takes up the goal that it planned ahead, and auctions the one after it: of
// all v ≠ that goal, in the order of I_v − 2·hops·V, the first for which it holds the lowest bid, or
// which is a neighbour of the goal with I_v > mean + 2 standard deviations of the idleness. V is the
// number of vertices, hops the edges on the shortest path from that goal, I_v the idleness in
// seconds; a vertex that nobody has visited counts as idle since −2·V s. If there is none, the v of
// the greatest utility. Its bid is D(v, centre)·(tasks + 1): tasks are the vertices for which it
// holds the lowest bid, the centre is the one of them with the least sum of shortest-path lengths D
// to all of them (the lowest number of equals; where it goes from if it has none). A bid that is
// lower than the one known for v replaces it.
#include <cstdint>
#include <vector>

#include "common/world/strategies/initial_idleness.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

class AuctionAssignment final : public Strategy {
 public:
  /// `paths` are those of `graph`; `paths` must outlive the strategy.
  AuctionAssignment(const PatrolGraph& graph, const ShortestPaths& paths);

  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .messages = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;
  void Hear(int receiver, int sender) override;

 private:
  struct Bid {
    double value_m = kNever_s;
    int holder = -1;  // −1: nobody
  };
  struct Goals {
    int next = -1;  // −1: none yet
    int after = -1;
  };

  Bid* bids(int robot) { return &bids_[vertices_ * robot]; }
  void Place(int robot, int bidder, int vertex, double value_m);
  void StartAnew(int robot);
  void VoidBidsOfAbsent(const Belief& belief);
  int Centre(int robot, int from);
  int Auction(const Belief& belief, int from, Rng& rng);

  const ShortestPaths* paths_;
  std::size_t vertices_;
  std::vector<std::uint16_t> hops_;  // (V, V)
  InitialIdleness idleness_;
  std::vector<Bid> bids_;           // (N, V) the lowest that each robot knows
  std::vector<Goals> goals_;        // (N)
  std::vector<double> said_m_;      // (N) 
  std::vector<int> tasks_;          // scratch
  std::vector<double> idle_s_;      // (V) scratch
};

}  // namespace ronda
