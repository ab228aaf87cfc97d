#pragma once
// Joins what an agent saw, chose and got into transitions over n steps.
//
// A transition of decision k says: observation k, action k, R = Σ_{j<n} (Π_{i<j} γ_i) r_{k+j}, the
// discount Π_{j<n} γ_j and observation k + n, where γ_j belongs to the step from decision k + j to
// the next. A reward may be settled later than the next observation (or than the next decision is
// settled): the transition waits for it. Each agent's transitions come out in the order of its
// decisions; agents interleave in the order in which they become complete.
//
// Call Observe, then Choose, for each decision; Settle for each reward; Finish at the end of an
// episode. At a terminal state the steps that are left are joined to the end with discount 0 (and
// action 0 marked as legal next, since some action must be). At a cut they bootstrap from the
// agent's last observation over as many steps as are settled; a decision with no reward or no
// observation after it is dropped. What is kept is bounded by what an episode leaves unsettled.
// Misuse (an action without an observation, a reward settled twice) is a bug. Thread-compatible.
// Source: Sutton, Precup & Singh 1999 (semi-MDP); Xiao, Hoffman & Amato 2019 (per-agent transitions
// of macro-actions).
#include <cstdint>
#include <deque>
#include <vector>

#include "common/rl/environment.h"
#include "common/rl/transition.h"

namespace ronda {

class NStepAdder {
 public:
  /// n ≥ 1, else InputError.
  NStepAdder(const EnvironmentSpec& spec, int n);

  void Observe(const Decision& decision);
  /// The action for what `agent` observed last, chosen with weights of this version.
  void Choose(int agent, int action, std::uint64_t weights_version);
  void Settle(const SettledReward& settled);
  /// The episode has ended. `last` is the observation to bootstrap from where it was cut.
  void Finish(EpisodeState state, const Decision& last);

  /// The transitions that have become complete; take them and leave it empty.
  std::deque<Transition>& completed() { return completed_; }
  std::uint64_t dropped() const { return dropped_; }  // decisions that made no transition, ever

 private:
  struct Step {
    std::vector<float> observation;   // (O)
    std::vector<std::uint8_t> legal;  // (A)
    std::uint64_t weights_version = 0;
    std::int32_t action = -1;  // −1: not chosen yet
    float discount = 1.0f;     // from the decision before to this one
    float reward = 0.0f;
    bool settled = false;
  };
  struct Agent {
    std::uint64_t first_index = 0;  // of steps.front()
    std::deque<Step> steps;         // consecutive decisions that made no transition yet
  };

  void Complete(int agent);
  void Flush(int agent, EpisodeState state);
  /// Pops the first step as a transition over its next `steps` (all settled); `terminal` where
  /// nothing follows, else the step after them is bootstrapped from.
  void Emit(int agent, std::size_t steps, bool terminal);
  static std::size_t SettledAhead(const Agent& agent, std::size_t at_most);

  EnvironmentSpec spec_;
  std::size_t n_;
  std::vector<Agent> agents_;  // (N)
  std::deque<Transition> completed_;
  std::uint64_t dropped_ = 0;
};

}  // namespace ronda
