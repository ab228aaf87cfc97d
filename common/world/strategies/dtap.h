#pragma once
// Dynamic Task Assignment by sequential single-item auction, DTAP (Farinelli, Iocchi & Nardi 2017):
// robots bid for the vertices, so that each comes to tend those about the middle of its own.
//
// A robot at its goal takes up the goal that it planned ahead, and plans the one after it: of all
// vertices but these two, in the order of the utility I_v − 2·hops·V, the first that it wins.
// V is the number of vertices, hops the edges on the shortest path from the goal, I_v the idleness
// in seconds; a vertex that nobody has visited counts as idle since −2·V s.
//
// A robot bids D(v, centre)·(tasks + 1). Its tasks are the vertices that it was the last to win;
// the centre is the one of them with the least sum of shortest-path lengths D to them all (the
// lowest number of equals; where it goes next, if it has none). Each other robot answers the lower
// of two bids: 0 if v is the next or the planned goal of it, else the bid that won it v. The lowest
// wins, and v is a task of its bidder; of equal ones that of the earlier holder. A robot also goes
// to a vertex that it does not win, if it is next to the goal, idle for more than the mean and 2
// standard deviations over all vertices, and nobody's goal.
//
// Choices. Auctions take no time, so nobody is asked: with each decision a robot says its goals and
// the bids that it made, and an answer is what was heard last. What a robot that is not on patrol
// won is free. A robot that wins nothing goes to the vertex of the greatest utility. Utilities that
// tie fall at random. A robot knows everyone's visits.
//
// A goal costs O(V·(log V + N + tasks)), every other decision O(1); O(N·(N + V)) memory.
#include <cstdint>
#include <vector>

#include "common/world/strategies/initial_idleness.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

class AuctionAssignment final : public Strategy {
 public:
  /// `paths` are those of `graph`; they must outlive the strategy.
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
    double value_m = 0.0;
    int holder = -1;  // −1: nobody's, and no value
  };
  struct Goals {
    int next = -1;  // −1: none
    int after = -1;

    bool contain(int vertex) const { return next == vertex || after == vertex; }
  };
  struct Candidate {
    double utility_s = 0.0;
    std::uint32_t draw = 0;  // orders equal utilities
    int vertex = 0;
  };
  struct MadeBid {
    int vertex = 0;
    Bid bid;
  };

  std::uint16_t& hops(int from, int to) { return hops_[vertices_ * from + to]; }
  Bid* bids(int robot) { return &bids_[vertices_ * robot]; }
  Goals& goals(int robot, int other) { return goals_[robots_ * robot + other]; }
  int PlanGoal(const Belief& belief, int from, Rng& rng);
  void RankCandidates(const Belief& belief, int from, Rng& rng);
  bool Wins(const Belief& belief, int vertex, int from);
  bool IsGoalOfAnother(const Belief& belief, int vertex);
  double OwnBid_m(int robot, int vertex, int from);

  const ShortestPaths* paths_;
  std::size_t vertices_;
  std::size_t robots_ = 0;
  std::vector<std::uint16_t> hops_;  // (V, V)
  InitialIdleness idleness_;
  std::vector<Bid> bids_;                   // (N, V) the last that won, as each robot knows it
  std::vector<Goals> goals_;                // (N, N) of each, as each knows them
  std::vector<std::vector<MadeBid>> made_;  // (N) with the last decision
  std::vector<Candidate> candidates_;       // scratch
  double high_s_ = 0.0;                     // scratch: mean + 2 standard deviations of idleness
  std::vector<int> tasks_;                  // scratch
};

}  // namespace ronda
