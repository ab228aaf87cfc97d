#pragma once
// Patrolling as an asynchronous semi-Markov decision process: one agent a robot, a decision at each
// arrival.
//
// The action of a robot waits in the buffer Φ until the robot has arrived (restrained action swap,
// thesis §4.2); then visit, reward and the next observation belong together. The discount of a step
// of τ seconds is exp(−τ / T_d). With the hindsight reward a decision settles when its vertex is
// visited next, by anyone, after 5 T_d at the latest, or at the end of the episode. An episode ends
// (kCut) with the first arrival after its time. Contract as rl/environment.h. The graph must
// outlive the environment. About 3 µs a decision.
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "common/environments/observation_encoder.h"
#include "common/environments/reward.h"
#include "common/rl/environment.h"
#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"

namespace ronda {

struct PatrolEnvironmentConfig {
  int agents = 10;
  double speed_mps = 1.0;
  double travel_noise = 0.0;
  double closed_walk_m = 0.0;   // L_tsp; T_ref = L_tsp / Σ speeds
  double horizon_t_ref = 0.3;   // T_d / T_ref
  double episode_t_ref = 40.0;  // length of an episode / T_ref
  std::string observation = "candidates";
  RewardScheme reward = RewardScheme::kHindsight;
};

class PatrolEnvironment final : public Environment {
 public:
  PatrolEnvironment(const PatrolGraph& graph, const ShortestPaths& paths,
                    const PatrolEnvironmentConfig& config);

  const EnvironmentSpec& spec() const override { return spec_; }
  void Reset(const Rng& rng) override;
  const Decision& decision() const override { return decision_; }
  StepOutcome Step(int action) override;

  const PatrolWorld& world() const { return world_; }
  double reference_s() const { return reference_s_; }  // T_ref
  double horizon_s() const { return horizon_s_; }      // T_d

 private:
  /// What Φ holds of one robot: its action and when it was chosen.
  struct Pending {
    int action = -1;  // −1: none yet
    double decided_s = 0.0;
    std::uint64_t index = 0;
  };
  /// A visit whose hindsight reward is not known yet.
  struct OpenVisit {
    int agent = 0;
    std::uint64_t index = 0;
    double visited_s = 0.0;
    Visit visit;
    bool open = false;
  };

  void Arrive(const Arrival& arrival);
  void Settle(OpenVisit& visit, double until_next_visit_s);
  void SettleLate(double now_s);
  void Observe(const Arrival& arrival, float discount);

  ObservationEncoder encoder_;
  PatrolEnvironmentConfig config_;
  EnvironmentSpec spec_;
  PatrolWorld world_;
  double reference_s_;
  double horizon_s_;
  Decision decision_;
  std::vector<Pending> phi_;            // (N) the buffer Φ
  std::vector<OpenVisit> open_visits_;  // (V) at most one a vertex
  struct Due {
    double visited_s;
    int vertex;
  };
  std::deque<Due> due_;  // visits in order of time
  std::vector<SettledReward> settled_;
  std::vector<float> observation_;   // (O)
  std::vector<std::uint8_t> legal_;  // (A)
};

}  // namespace ronda
