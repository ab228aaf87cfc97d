#pragma once
// Mini-batches of random numbers in the shape of a network: the learner's work without a replay.
#include "common/base/rng.h"
#include "common/nn/network_spec.h"
#include "common/rl/messages.h"

namespace ronda::bench {

inline std::vector<float> RandomFloats(Rng& rng, std::size_t size) {
  std::vector<float> values(size);
  for (float& value : values) value = static_cast<float>(rng.Normal());
  return values;
}

/// `count` transitions; each next action is legal with probability `legal`, one at least.
inline SampledBatch RandomBatch(const NetworkSpec& spec, std::uint32_t count, double legal,
                                Rng& rng) {
  const auto observation_size = static_cast<std::uint32_t>(spec.observation_size);
  const auto num_actions = static_cast<std::uint32_t>(spec.num_actions);
  SampledBatch batch;
  batch.shape = {.observation_size = observation_size, .num_actions = num_actions};
  batch.count = count;
  batch.observations = RandomFloats(rng, std::size_t{count} * observation_size);
  batch.next_observations = RandomFloats(rng, std::size_t{count} * observation_size);
  batch.rewards = RandomFloats(rng, count);
  batch.discounts.assign(count, 0.9f);
  batch.importance_weights.assign(count, 1.0f);
  for (std::uint32_t i = 0; i < count; ++i) {
    batch.actions.push_back(static_cast<std::int32_t>(rng.Below(num_actions)));
    const std::uint32_t sure = rng.Below(num_actions);
    for (std::uint32_t a = 0; a < num_actions; ++a)
      batch.next_legal_actions.push_back(a == sure || rng.Uniform() < legal ? 1 : 0);
  }
  return batch;
}

}  // namespace ronda::bench
