#pragma once
// One good value of each message, and all fields of a value as a tuple that compares. Pure.
#include <tuple>

#include "common/rl/messages.h"

namespace ronda {

inline constexpr TransitionShape kShape{.observation_size = 3, .num_actions = 2, .extras_size = 1};

/// The n-th transition: its reward is its number, and every array follows from it.
Transition NumberedTransition(std::uint64_t n);

TransitionBatch GoodTransitionBatch(std::uint32_t count);
ReplayStatus GoodReplayStatus();
SampleRequest GoodSampleRequest();
SampledBatch GoodSampledBatch(std::uint32_t count);
PriorityUpdate GoodPriorityUpdate();
WeightSnapshot GoodWeightSnapshot();
ProcessReport GoodProcessReport();
RunControl GoodRunControl();

inline auto Fields(const TransitionBatch& v) {
  return std::tie(v.actor, v.actor_incarnation, v.replay_incarnation, v.first_sequence,
                  v.oldest_unconfirmed, v.shape, v.count, v.observations, v.actions, v.rewards,
                  v.discounts, v.next_observations, v.next_legal_actions, v.extras, v.agents,
                  v.weights_versions);
}
inline auto Fields(const ActorCredit& v) {
  return std::tie(v.actor, v.actor_incarnation, v.stored_through, v.window_end);
}
inline auto Fields(const SampleRequest& v) {
  return std::tie(v.learner_incarnation, v.first_id, v.end_id, v.batch_size);
}
inline auto Fields(const SampledBatch& v) {
  return std::tie(v.replay_incarnation, v.learner_incarnation, v.id, v.shape, v.count,
                  v.observations, v.actions, v.rewards, v.discounts, v.next_observations,
                  v.next_legal_actions, v.extras, v.weights_versions, v.keys, v.importance_weights);
}
inline auto Fields(const PriorityUpdate& v) {
  return std::tie(v.replay_incarnation, v.keys, v.priorities);
}
inline auto Fields(const WeightSnapshot& v) {
  return std::tie(v.learner_incarnation, v.version, v.updates, v.architecture_hash, v.values);
}
inline auto Fields(const ProcessReport& v) {
  return std::tie(v.role, v.index, v.incarnation, v.pid, v.state, v.metrics);
}
inline auto Fields(const RunControl& v) { return std::tie(v.progress, v.actors); }

template <typename Value>
bool Same(const Value& a, const Value& b) {
  return Fields(a) == Fields(b);
}
bool Same(const ReplayStatus& a, const ReplayStatus& b);

}  // namespace ronda
