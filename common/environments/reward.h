#pragma once
// Rewards of one decision: pure functions of the visit that it led to, chosen by name.
//
// A decision takes τ seconds until the robot arrives at a vertex v. ζ is idleness just before the
// visit resets it, ζ̄ its mean over the V vertices, γ = exp(−1/T_d) a second. A reward is γ^τ (to
// the moment of the decision) · value · scale; the scale makes it of order 1 for any map and team:
//
//   name           value                                                            scale
//   idleness       ζ(v)                                             §4.3.1          2/T_ref
//   ranking        rank of v by ζ, 1 … V, the most idle V           §4.3.2          1/V
//   normalised     (ζ(v) − ζmin)/(ζmax − ζmin), 0 where all equal   §4.3.3          1
//   centred        ζ(v) − ζ̄                                         §4.3.4          2/T_ref
//   average        −ζ̄                                               §4.3.5          2/T_ref
//   n-worst        1 if fewer than n vertices are more idle, else 0 §4.3.6          1
//   final-average  −ζ̄ at the arrival that ends the episode, else 0  §4.3.7          2/T_ref
//   hindsight      ζ(v)·(1 − γ^Δ), Δ until anyone visits v next     (see below)     2/T_ref
//
// Ties: ranking counts the lower index as less idle, so ranks are a permutation (the thesis asks
// for some fixed order); n-worst counts all that are as idle as the n-th, so n ≥ V gives always 1.
// The thesis writes +ζ̄ in the two averages; the sign here makes less idleness better. O(V) a
// reward, O(1) for idleness, hindsight. Finite for finite ζ, τ ≥ 0 and T_d, T_ref > 0. Source:
// thesis §4.3; difference rewards (Wolpert & Tumer 2002) for hindsight.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ronda {

enum class RewardScheme {
  kIdleness,
  kRanking,
  kNormalised,
  kCentred,
  kAverage,
  kNWorst,
  kFinalAverage,
  kHindsight,
};

/// In the order of the table above.
std::vector<std::string> RewardNames();
/// One of RewardNames(); else UsageError that lists them.
RewardScheme ParseRewardScheme(const std::string& name);
std::string_view Name(RewardScheme scheme);

struct RewardParameters {
  double horizon_s = 0.0;    // T_d
  double reference_s = 0.0;  // T_ref
  int n_worst = 3;           // n ≥ 1
};

struct Visit {
  double travel_s = 0.0;               // τ, from the decision to the arrival
  int vertex = 0;                      // v
  std::span<const double> idleness_s;  // (V) ζ, just before the visit
  bool last_step = false;              // the arrival at which the episode ends
};

/// γ^τ: what a value `duration_s` ahead is worth now. In (0, 1]: never rounded to 0, which would
/// mean a terminal state.
float Discount(double duration_s, double horizon_s);

/// The table's value, neither discounted nor scaled; of hindsight what holds for Δ = ∞.
double RewardValue(RewardScheme scheme, const Visit& visit, const RewardParameters& parameters);

/// γ^τ · value · scale.
float Reward(RewardScheme scheme, const Visit& visit, const RewardParameters& parameters);

/// Whether the reward is settled only when somebody visits the vertex next: HindsightReward then
/// tells what is left of it.
bool WaitsForNextVisit(RewardScheme scheme);

/// `reward` · (1 − γ^Δ), with Δ the time until anyone visits the vertex next (∞: nobody does): the
/// part that the team would not have collected anyway by then.
float HindsightReward(float reward, double next_visit_after_s, const RewardParameters& parameters);

}  // namespace ronda
