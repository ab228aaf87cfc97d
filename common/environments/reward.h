#pragma once
// Rewards of one decision: pure functions of the visit that it led to.
//
// A decision takes τ seconds until the robot arrives and visits a vertex that had been idle for ζ.
// Rewards are discounted to the moment of the decision, with γ = exp(−1/T_d) a second, and scaled
// by 2/T_ref, which makes them of order 1 for any map and team. Finite for finite ζ, τ ≥ 0 and
// T_d, T_ref > 0. Source: thesis §4.3 (idleness, before the visit resets it); difference rewards
// (Wolpert & Tumer 2002) for hindsight.
#include <string>
#include <string_view>

namespace ronda {

enum class RewardScheme {
  kIdleness,   // ζ, known on arrival
  kHindsight,  // ζ·(1 − γ^Δ), known when somebody visits the vertex next
};

/// "idleness" or "hindsight"; else UsageError that lists the names.
RewardScheme ParseRewardScheme(const std::string& name);
std::string_view Name(RewardScheme scheme);

struct RewardScale {
  double horizon_s = 0.0;    // T_d
  double reference_s = 0.0;  // T_ref
};

struct Visit {
  double travel_s = 0.0;    // τ, from the decision to the arrival
  double idleness_s = 0.0;  // ζ, just before the visit
};

/// γ^τ: what a value `duration_s` ahead is worth now. In (0, 1]: never rounded to 0, which would
/// mean a terminal state.
float Discount(double duration_s, double horizon_s);

/// γ^τ · ζ · 2/T_ref.
float IdlenessReward(const Visit& visit, const RewardScale& scale);

/// γ^τ · ζ · (1 − γ^Δ) · 2/T_ref, with Δ the time until anyone visits the vertex next (∞: nobody
/// does): the part of ζ that the team would not have collected anyway by then.
float HindsightReward(const Visit& visit, double next_visit_after_s, const RewardScale& scale);

}  // namespace ronda
