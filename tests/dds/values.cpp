#include "tests/dds/values.h"

#include <algorithm>

namespace ronda {

Transition NumberedTransition(std::uint64_t n) {
  const auto value = static_cast<float>(n);
  return {.observation = {value, -value, 0.25f},
          .action = static_cast<std::int32_t>(n % 2),
          .reward = value,
          .discount = 0.5f,
          .next_observation = {value + 1.0f, 0.0f, -0.25f},
          .next_legal_actions = {1, static_cast<std::uint8_t>(n % 2)},
          .extras = {value / 2},
          .agent = static_cast<std::uint32_t>(n % 5),
          .weights_version = n};
}

TransitionBatch GoodTransitionBatch(std::uint32_t count) {
  TransitionBatch batch;
  batch.actor = 4;
  batch.actor_incarnation = 1'000'000'007;
  batch.replay_incarnation = 1'000'000'009;
  batch.first_sequence = 101;
  batch.oldest_unconfirmed = 96;
  batch.shape = kShape;
  for (std::uint64_t n = 101; n < 101 + count; ++n) batch.Append(NumberedTransition(n));
  return batch;
}

ReplayStatus GoodReplayStatus() {
  ReplayStatus status;
  status.replay_incarnation = 12;
  status.size = 900;
  status.capacity = 1000;
  status.stored = 5000;
  status.sampled = 40'000;
  status.repeats_dropped = 17;
  status.doubled = 1;
  status.messages_refused = 2;
  status.inserts_wait = 1;
  status.samples_wait = 0;
  status.actors = {{0, 21, 100, 356}, {1, 22, 0, 256}, {0, 7, 5, 5}};
  return status;
}

SampleRequest GoodSampleRequest() {
  return {.learner_incarnation = 31, .first_id = 400, .end_id = 408, .batch_size = 128};
}

SampledBatch GoodSampledBatch(std::uint32_t count) {
  const TransitionBatch rows = GoodTransitionBatch(count);
  SampledBatch batch;
  batch.replay_incarnation = 12;
  batch.learner_incarnation = 31;
  batch.id = 400;
  batch.shape = rows.shape;
  batch.count = rows.count;
  batch.observations = rows.observations;
  batch.actions = rows.actions;
  batch.rewards = rows.rewards;
  batch.discounts = rows.discounts;
  batch.next_observations = rows.next_observations;
  batch.next_legal_actions = rows.next_legal_actions;
  batch.extras = rows.extras;
  batch.weights_versions = rows.weights_versions;
  for (std::uint32_t row = 0; row < count; ++row) {
    batch.keys.push_back(7'000'000'000 + row);
    batch.importance_weights.push_back(1.0f / static_cast<float>(row + 1));
  }
  return batch;
}

PriorityUpdate GoodPriorityUpdate() {
  return {.replay_incarnation = 12,
          .keys = {3, 7'000'000'000, 5, 5},
          .priorities = {0.0f, 1.5f, 0.001f, 1e30f}};
}

WeightSnapshot GoodWeightSnapshot() {
  WeightSnapshot snapshot{.learner_incarnation = 31,
                          .version = 55,
                          .updates = 5500,
                          .architecture_hash = 0xfedcba9876543210,
                          .values = {}};
  for (int i = 0; i < 500; ++i) snapshot.values.push_back(0.01f * static_cast<float>(i - 250));
  return snapshot;
}

ProcessReport GoodProcessReport() {
  return {.role = "actor",
          .index = 3,
          .incarnation = 21,
          .pid = 4321,
          .state = "waiting for credit from the replay",
          .metrics = {{"decisions", 1e6}, {"sent", 123.0}, {"epsilon", 0.05}}};
}

RunControl GoodRunControl() { return {.progress = 0.375, .actors = 6}; }

bool Same(const ReplayStatus& a, const ReplayStatus& b) {
  const auto counters = [](const ReplayStatus& v) {
    return std::tie(v.replay_incarnation, v.size, v.capacity, v.stored, v.sampled,
                    v.repeats_dropped, v.doubled, v.messages_refused, v.inserts_wait,
                    v.samples_wait);
  };
  return counters(a) == counters(b) &&
         std::ranges::equal(a.actors, b.actors, [](const ActorCredit& x, const ActorCredit& y) {
           return Fields(x) == Fields(y);
         });
}

}  // namespace ronda
