#pragma once
// Graph patrolling as an environment to learn in: each robot is an agent that decides on its
// arrivals (asynchronous mode, thesis §3.2, with restrained action swap, §4.2).
//
// A semi-MDP: the discount of an edge that took τ seconds is γ^τ with γ = exp(−1/T_d). A robot is
// asked only where it has arrived; what it chose then stands until its next arrival, where the
// visit decides the reward of that choice (reward.h). A reward that waits for the next visit of the
// same vertex by anyone does so for at most 5 T_d (it then counts as never).
//
// Each episode starts from random vertices, at random idleness where asked for. It is cut at the
// first arrival at or after its length: every decision that has arrived is settled by then (without
// a next visit: never), those under way are dropped. So the last step, where final-average is
// given, is the one arrival that ends the episode: one decision of one robot. A robot that fails
// leaves its decision unsettled; if it joins again, that decision's reward is 0. Staying put is
// rewarded at once, as the visit of a vertex that has been idle for so long. T_ref = closed
// walk / Σ speeds is the unit of all times in the options. Errors: InputError for options out of
// range. Thread-compatible. O(A·V + N·V) a step, no allocation once warm. Source: thesis §1.3,
// §3.2, §4.2.
#include <cstdint>
#include <vector>

#include "common/environments/observation_encoder.h"
#include "common/environments/reward.h"
#include "common/rl/environment.h"
#include "common/world/conditions.h"
#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"
#include "common/world/team_beliefs.h"

namespace ronda {

struct PatrolEnvironmentOptions {
  int agents = 10;                      // N ≥ 1
  Conditions conditions = {};           // without priorities: those are the graph's
  double closed_walk_m = 0.0;           // > 0, length of a short closed walk through all vertices
  double horizon = 0.3;                 // T_d in T_ref, > 0
  double episode_length = 40.0;         // in T_ref, > 0
  double initial_idleness = 0.0;        // each vertex starts idle for up to so many T_ref; ≥ 0
  ObservationOptions observation = {};  // its robots and stay follow from the above
  RewardScheme reward = RewardScheme::kHindsight;
  int reward_n_worst = 3;  // n of n-worst, ≥ 1
};

/// What its agents observe, with what follows from team and conditions.
ObservationOptions ObservationOf(const PatrolEnvironmentOptions& options);

class PatrolEnvironment final : public Environment {
 public:
  /// `graph` must outlive it; `paths` are the graph's, and are not kept.
  PatrolEnvironment(const PatrolGraph& graph, const ShortestPaths& paths,
                    const PatrolEnvironmentOptions& options);

  const EnvironmentSpec& spec() const override { return spec_; }
  void Reset(const Rng& rng) override;
  const Decision& decision() const override { return decision_; }
  StepOutcome Step(int action) override;

  const PatrolWorld& world() const { return world_; }
  const ObservationEncoder& encoder() const { return encoder_; }

 private:
  /// A decision under way: made at `made_s`; `count` decisions of this agent so far.
  struct Agent {
    std::uint64_t count = 0;
    double made_s = 0.0;
  };
  /// A visit whose reward waits for the next visit of the same vertex; none if agent < 0.
  struct Pending {
    int agent = -1;
    std::uint64_t index = 0;
    double since_s = 0.0;
    float reward = 0.0f;  // should nobody come
  };

  void SettleArrival(const Arrival& arrival, bool last_step);
  void SettleLate(double now_s);
  void SettlePending(int vertex, double next_visit_after_s);
  void MakeDecision(const Arrival& arrival);

  PatrolEnvironmentOptions options_;
  RewardParameters parameters_;
  double settle_within_s_;
  double episode_s_;
  PatrolWorld world_;
  TeamBeliefs beliefs_;
  ObservationEncoder encoder_;
  EnvironmentSpec spec_;
  EpisodeState state_ = EpisodeState::kCut;  // until the first Reset
  std::vector<Agent> agents_;                // (N)
  std::vector<Pending> pending_;             // (V)
  std::vector<double> idleness_s_;           // (V) just before the present visit
  std::vector<SettledReward> settled_;
  std::vector<float> observation_;   // (O)
  std::vector<std::uint8_t> legal_;  // (A)
  Decision decision_;
};

}  // namespace ronda
