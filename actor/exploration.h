#pragma once
// How often an actor acts at random: ε as a pure function of the run's progress and of the actor.
//
// The decays are of the thesis (§2.2: linear ε0 − δt, exponential ε0·e^(−λt)), with t the share of
// the budget that is used and δ, λ such that `end` is reached after `share`; then ε stays. A ladder
// among n actors raises ε to 1 + α·i/(n − 1) (Horgan et al. 2018; exponent 1 for n = 1): the first
// explores most. InputError for options out of range.
#include <string>
#include <string_view>

namespace ronda {

enum class ExplorationDecay { kLinear, kExponential };

/// "linear" or "exponential"; else UsageError that lists the names.
ExplorationDecay ParseExplorationDecay(const std::string& name);
std::string_view Name(ExplorationDecay decay);

struct ExplorationOptions {
  ExplorationDecay decay = ExplorationDecay::kLinear;
  double start = 1.0;   // ε at progress 0, 0 … 1
  double end = 0.05;    // ε from progress `share` on, 0 … 1; both > 0 where exponential
  double share = 0.3;   // of the budget, > 0 … 1
  double ladder = 0.0;  // α ≥ 0; 0: all actors alike
};

void CheckExploration(const ExplorationOptions& options);

/// ε of the schedule at `progress` (0 … 1; clamped), for one actor alone.
double ScheduledEpsilon(const ExplorationOptions& options, double progress);

/// ε of actor `index` of `actors` (0 ≤ index < actors) at `progress`.
double Epsilon(const ExplorationOptions& options, double progress, int index, int actors);

}  // namespace ronda
