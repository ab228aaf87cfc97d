#pragma once
// What is learned from: one decision of one agent, and what came of it.
//
// `discount` multiplies the value of the next observation: γ^τ for a step that took τ seconds
// (semi-Markov), the product of them over n steps, 0 at a terminal state. There is no `done`. Plain
// values; copyable. Source: Sutton, Precup & Singh 1999 (semi-MDP); thesis §2.4.
#include <cstdint>
#include <vector>

namespace ronda {

/// Sizes that actor, replay and learner must agree on; every message carries them.
struct TransitionShape {
  std::uint32_t observation_size = 0;  // O
  std::uint32_t num_actions = 0;       // A
  std::uint32_t extras_size = 0;       // X: floats whose meaning the algorithm gives
  friend bool operator==(const TransitionShape&, const TransitionShape&) = default;
};

struct Transition {
  std::vector<float> observation;                // (O)
  std::int32_t action = 0;                       // 0 … A − 1
  float reward = 0.0f;                           // discounted to the moment of the decision
  float discount = 0.0f;                         // 0 … 1
  std::vector<float> next_observation;           // (O); zeros where discount = 0
  std::vector<std::uint8_t> next_legal_actions;  // (A); 1 where legal; at least one, always
  std::vector<float> extras;                     // (X)
  std::uint32_t agent = 0;
  std::uint64_t weights_version = 0;  // of the policy that chose the action
};

/// Transitions of one actor with consecutive sequence numbers, struct of arrays, row-major.
struct TransitionBatch {
  std::uint32_t actor = 0;
  std::uint64_t actor_incarnation = 0;   // differs for every start of a process
  std::uint64_t replay_incarnation = 0;  // the replay that this is meant for
  std::uint64_t first_sequence = 1;      // of the first transition here; an actor's first is 1
  std::uint64_t oldest_unconfirmed = 1;  // nothing before it will be sent again
  TransitionShape shape;
  std::uint32_t count = 0;                       // n; 0 announces an actor
  std::vector<float> observations;               // (n, O)
  std::vector<std::int32_t> actions;             // (n)
  std::vector<float> rewards;                    // (n)
  std::vector<float> discounts;                  // (n)
  std::vector<float> next_observations;          // (n, O)
  std::vector<std::uint8_t> next_legal_actions;  // (n, A)
  std::vector<float> extras;                     // (n, X)
  std::vector<std::uint32_t> agents;             // (n)
  std::vector<std::uint64_t> weights_versions;   // (n)

  void Append(const Transition& transition);  // sizes as `shape` says, else a bug
  void Clear();                               // count 0, memory kept
};

}  // namespace ronda
