#pragma once
// A world that agents act in, asynchronously: a semi-Markov decision process for each agent over
// one clock.
//
// At any moment at most one agent is asked for an action (`decision`). Its reward may be known
// later than its next observation (the hindsight reward waits for the next visit of a vertex), so
// rewards are *settled* by number: an agent's k-th decision of the episode has index k, from 0.
// Every decision is settled exactly once or dropped by the end of the episode. Deterministic: the
// same rng and actions give the same episode. Thread-compatible. Source: Sutton, Precup & Singh
// 1999; Amato et al. 2019 (macro-actions); thesis §3.2, §4.2.
#include <cstdint>
#include <span>

#include "common/base/rng.h"

namespace ronda {

struct EnvironmentSpec {
  int observation_size = 0;  // O
  int num_actions = 0;       // A
  int num_agents = 1;
};

struct Decision {
  int agent = 0;
  std::uint64_t index = 0;  // of this decision among the agent's decisions of the episode
  std::span<const float> observation;           // (O) valid until the next Step or Reset
  std::span<const std::uint8_t> legal_actions;  // (A) at least one is 1; valid as above
  float discount = 1.0f;  // γ^τ since this agent's decision before; 1 for its first
};

struct SettledReward {
  int agent = 0;
  std::uint64_t index = 0;
  float reward = 0.0f;  // discounted to the moment of the decision
};

enum class EpisodeState {
  kRunning,
  kTerminal,  // a terminal state: what each agent did last has discount 0
  kCut,       // a time limit: `decision` holds one last observation to bootstrap from, and takes no
              // action
};

struct StepOutcome {
  EpisodeState state = EpisodeState::kRunning;
  std::span<const SettledReward> settled;  // valid until the next Step or Reset
};

class Environment {
 public:
  virtual ~Environment() = default;
  virtual const EnvironmentSpec& spec() const = 0;
  /// Starts an episode; afterwards `decision` is the first. All randomness comes from `rng`.
  virtual void Reset(const Rng& rng) = 0;
  virtual const Decision& decision() const = 0;
  /// Takes the action (a legal one, else a bug) for the agent of `decision` and runs on to the next
  /// decision.
  virtual StepOutcome Step(int action) = 0;
};

}  // namespace ronda
