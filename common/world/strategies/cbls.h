#pragma once
// Concurrent Bayesian Learning Strategy, CBLS (Portugal & Rocha 2016): each robot learns which arcs
// lead to places that need a visit, while it patrols.
//
// Candidates: the neighbours that nobody else heads to or stands on, all of them where there is
// none. For each of them
//   prior       ∝ 0.75·A_j + 0.25·max A over j's other neighbours that nobody heads to (A_j where
//               there is none), A = (mean interval · count + I)/(count + 1)
//   likelihood  h(arc to j) / Σ h over the candidates; h is 1 at first
// and the robot takes the greatest posterior, prior × likelihood. When it arrives, h(arc to j) +=
// s_j·(1 − H) for each candidate j of that choice, kept within [0.5, 2]: s is +1 for the most idle
// one, −1 for the least idle one, else 0, all by then, so it is −1 for the one that it came to; H
// is the entropy of the posterior over the log of the number of candidates. 0/0 is 0.
//
// Choices. The intervals between visits tile the time since the start, so A = t/(count + 1), times
// the vertex's weight. A visit at time 0 ends no interval and is not counted. Candidates that are
// all equally idle have s = 0, and H is 1 where no posterior is above 0.
//
// A robot knows everyone's visits, counts them as it hears of them, and knows where the others
// head; h is its own and outlives its failures. Ties fall to the shorter edge, then at random. As A
// is a mean since the start, a long episode makes the robots slow to notice what is idle now.
// O(degree² · N) a decision; O(N·(V + E)) memory.
#include <cstdint>
#include <vector>

#include "common/world/strategies/strategy.h"

namespace ronda {

class ConcurrentBayesianLearning final : public Strategy {
 public:
  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  Knowledge knowledge() const override {
    return {.visits = Knowledge::Visits::kShared, .intentions = true, .messages = true};
  }
  int Decide(const Belief& belief, Rng& rng) override;
  void Hear(int receiver, int sender) override;

 private:
  /// What a robot chose from where it stood last.
  struct Choice {
    int vertex = 0;
    std::vector<int> candidates;  // places among its neighbours
    double certainty = 0.0;       // 1 − H
  };

  void CountVisit(int robot, int vertex);
  void Learn(const Belief& belief, const Choice& choice);
  double MeanIdleness_s(const Belief& belief, int vertex) const;
  double Prior(const Belief& belief, int candidate) const;
  int Best(const Belief& belief, const std::vector<int>& candidates, Rng& rng) const;
  double& likelihood(int robot, int arc) { return likelihoods_[arcs_ * robot + arc]; }

  std::size_t vertices_ = 0;
  std::size_t arcs_ = 0;
  std::vector<std::uint32_t> visits_;  // (N, V) that the robot knows of
  std::vector<int> visited_;           // (N) with the last decision; −1: at time 0
  std::vector<double> likelihoods_;    // (N, arcs) h
  std::vector<Choice> choices_;        // (N) the last
  std::vector<double> posteriors_;     // scratch
};

}  // namespace ronda
