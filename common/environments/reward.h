#pragma once
// What a visit is worth: named pure functions of the visit, discounted to the moment of the
// decision that led to it.
//
// ζ is the idleness of the visited vertex before the visit reset it, τ the time from the decision
// to the arrival, Δ the time until anyone visits the vertex again (∞ where none came in time), γ
// per second. Scaled by 2 / T_ref, so values are about 1.
#include <string>
#include <vector>

namespace ronda {

enum class RewardScheme {
  kIdleness,  // γ^τ · ζ: own idleness (thesis §4.3)
  kHindsight,  // γ^τ · ζ · (1 − γ^Δ): what the team would have lost without this visit; known at
               // the next visit
};

/// "idleness", "hindsight"; else InputError that lists them.
RewardScheme ParseRewardScheme(const std::string& name);
std::vector<std::string> RewardSchemeNames();

struct Visit {
  double idleness_s = 0.0;   // ζ
  double travel_s = 0.0;     // τ
  double horizon_s = 0.0;    // T_d = −1 / ln γ
  double reference_s = 0.0;  // T_ref
};

float IdlenessReward(const Visit& visit);
float HindsightReward(const Visit& visit, double until_next_visit_s);

}  // namespace ronda
