#pragma once
// Judges the policy while it trains, on a niced thread of its own: keeps the best, and the
// classical yardstick.
//
// First all classical strategies (steady protocol, 20 episodes, seed 1) and the lower bounds; then,
// whenever progress has moved by `step`, the newest weights on evaluation seeds that nobody
// reports, and the best goes to checkpoints/best.ronda. Policies of the second half of the budget
// are preferred to those of the first, whose weights are still in motion. Thread-safe.
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "common/evaluation/statistics.h"
#include "common/policies/policy_file.h"
#include "common/rl/ports.h"
#include "common/world/bounds.h"
#include "common/world/conditions.h"
#include "common/world/strategies/strategy.h"
#include "deploy/run_state.h"

namespace ronda {

struct TrainingEvaluatorConfig {
  int agents = 10;
  Conditions conditions = {};
  int episodes = 10;
  double step = 1.0 / 30.0;  // of progress, between two evaluations
  std::uint64_t seed = 0;
  PolicyFile policy;  // everything but weights, version, updates, decisions and time
  std::filesystem::path checkpoints;
};

/// How far the run is: the share of its budget, and what that is in decisions and time.
struct TrainingProgress {
  double share = 0.0;
  std::uint64_t decisions = 0;
  double training_s = 0.0;
};

struct PolicyEvaluation {
  double progress = 0.0;
  std::uint64_t updates = 0;
  double agi_s = 0.0;
};

/// The best classical strategy under the run's conditions.
struct Yardstick {
  std::string strategy;
  Estimate agi_s;
  std::optional<LowerBounds> bounds;  // nullopt: as BoundsOf
};

class TrainingEvaluator {
 public:
  /// `weights` is used by the evaluator's thread only; both references must outlive it.
  TrainingEvaluator(const TrainingEvaluatorConfig& config, const StrategyContext& context,
                    WeightSource& weights, const std::optional<BestPolicy>& best);
  ~TrainingEvaluator();

  void set_progress(const TrainingProgress& progress);
  /// Evaluations since the last call, oldest first.
  std::vector<PolicyEvaluation> TakeNew();
  std::optional<Yardstick> yardstick() const;  // nullopt until it is known
  std::optional<BestPolicy> best() const;
  /// Judges the last weights too, unless `hurry`; then stops. No more evaluations after it.
  void Finish(bool hurry);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// AGI of a policy file: steady protocol, 20 episodes, seed 1; nullopt when `stop` came first, or
/// when it took longer than `at_most`.
std::optional<Estimate> ReportedAgi(const PolicyFile& policy, const TrainingEvaluatorConfig& config,
                                    const StrategyContext& context, std::stop_token stop,
                                    std::chrono::milliseconds at_most);

}  // namespace ronda
