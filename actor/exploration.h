#pragma once
// How often an actor acts at random: ε as a function of the share of the budget that is used, and
// of the actor.
//
// Pure functions. Sources: thesis §2.2 (linear and exponential decay); the ladder ε^(1 + α·i/(n−1))
// of Horgan et al. 2018.
#include <cstdint>
#include <string>

namespace ronda {

struct ExplorationConfig {
  enum class Schedule { kLinear, kExponential };
  Schedule schedule = Schedule::kLinear;
  double start = 1.0;
  double end = 0.05;
  double share = 0.3;         // linear: of the budget, until `end` is reached
  double decay = 10.0;        // exponential: λ per budget
  double ladder_alpha = 0.0;  // 0: all actors alike
};

/// ε of actor `index` of `actors` at `progress` (0 … 1).
double Epsilon(const ExplorationConfig& config, double progress, std::uint32_t index,
               std::uint32_t actors);

}  // namespace ronda
