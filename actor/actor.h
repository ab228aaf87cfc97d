#pragma once
// The duty cycle of an actor: decide, step the environment, hand transitions on, take new weights.
//
// One Step is one decision. Weights load between two decisions only, so a decision has one version.
// While the sink throttles, what is complete waits in an outbox and no decision is made, so the
// outbox holds no more than one step completes and nothing is lost or pushed twice. Acts ε-greedily
// over the legal actions; at random before any weights have come. Episode e of actor i draws from a
// stream that follows from (seed, i, e) alone. Environment, policy and ports must outlive it.
// Thread-compatible.
// InputError for options out of range. Source: thesis §2.2, §2.4; Horgan et al. 2018.
#include <algorithm>
#include <cstdint>

#include "actor/exploration.h"
#include "actor/n_step_adder.h"
#include "common/base/rng.h"
#include "common/rl/environment.h"
#include "common/rl/policy.h"
#include "common/rl/ports.h"

namespace ronda {

struct ActorOptions {
  std::uint64_t seed = 1;
  int index = 0;   // of this actor, 0 … actors − 1
  int actors = 1;  // of the run
  int n_step = 1;
  ExplorationOptions exploration = {};
};

struct ActorCounters {
  std::uint64_t decisions = 0;
  std::uint64_t episodes = 0;         // ended
  std::uint64_t transitions = 0;      // accepted by the sink
  std::uint64_t dropped = 0;          // decisions that an episode's end left without a transition
  std::uint64_t throttled = 0;        // steps that could make no decision
  std::uint64_t weights_version = 0;  // of the policy's weights; 0: none yet
  std::uint64_t weights_refused = 0;  // snapshots of another architecture, or not finite
};

class Actor {
 public:
  Actor(Environment& environment, Policy& policy, TransitionSink& sink, WeightSource& weights,
        const ActorOptions& options);

  /// Makes one decision. Returns the decisions made: 0 where throttled or closed.
  int Step();

  void set_progress(double progress) { progress_ = progress; }
  /// How many actors the run has now; fewer than this one's index says: this one is leaving.
  void set_actors(int actors) { options_.actors = std::max(actors, options_.index + 1); }
  double epsilon() const;
  bool closed() const { return closed_; }  // the sink takes no more
  const ActorCounters& counters() const { return counters_; }

 private:
  bool EmptyOutbox();
  void LoadNewestWeights();
  void BeginEpisode();
  int Choose(const Decision& decision);

  Environment& environment_;
  Policy& policy_;
  TransitionSink& sink_;
  WeightSource& weights_;
  ActorOptions options_;
  NStepAdder adder_;
  std::uint64_t episode_seed_;
  Rng exploration_rng_;
  bool in_episode_ = false;
  bool has_weights_ = false;
  bool closed_ = false;
  double progress_ = 0.0;
  ActorCounters counters_;
};

}  // namespace ronda
