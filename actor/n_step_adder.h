#pragma once
// Joins what belongs together: a decision, its reward (which may be known later than the next
// observation) and the observation n decisions on, for each agent by itself.
//
//   R = Σ_{j<n} (Π_{l<j} γ_l) r_j,   discount = Π_{l<n} γ_l,   next observation: the agent's n-th
//   decision after
//
// An agent's transitions come out in the order of its decisions. At a terminal state what is left
// ends with discount 0; at a cut it bootstraps from the agent's latest observation, and a decision
// that has none after it is dropped. Holds for each agent what is not settled yet: bounded by the
// environment's latest settlement. Thread-compatible. Source: Sutton & Barto 2018 §7.1; semi-MDP
// discounts multiply (Sutton, Precup & Singh 1999).
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "common/rl/environment.h"
#include "common/rl/transition.h"

namespace ronda {

class NStepAdder {
 public:
  NStepAdder(const EnvironmentSpec& spec, int n_steps);

  /// The agent has decided; its decision before gets this observation as its next.
  void Decide(const Decision& decision, int action, std::uint64_t weights_version);
  /// A last observation at a cut: the decision before gets it, and no action follows.
  void Observe(const Decision& decision);
  void Settle(std::span<const SettledReward> settled);
  /// Ends the episode (kTerminal or kCut): all that can be completed comes out, the rest is
  /// dropped.
  void EndEpisode(EpisodeState state);

  /// Completed transitions, oldest first; the caller pops them.
  std::deque<Transition>& completed() { return completed_; }

 private:
  struct Step {
    std::uint64_t index = 0;
    std::vector<float> observation;           // (O)
    std::vector<std::uint8_t> legal_actions;  // (A)
    int action = -1;                          // −1: a last observation
    std::uint64_t weights_version = 0;
    float discount = 1.0f;  // from this decision to the next
    float reward = 0.0f;
    bool settled = false;
  };

  void Append(const Decision& decision, int action, std::uint64_t weights_version);
  /// Completes the agent's steps from the front that have `n` settled decisions and an observation
  /// after them.
  void Emit(int agent);
  Transition Complete(const std::deque<Step>& steps, std::uint32_t agent, std::size_t length) const;

  EnvironmentSpec spec_;
  std::size_t n_steps_;
  std::vector<std::deque<Step>> steps_;  // by agent
  std::deque<Transition> completed_;
};

}  // namespace ronda
