#include "replay/replay_buffer.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

template <class T>
void CopyRow(const std::vector<T>& from, std::size_t from_row, std::vector<T>& to,
             std::size_t to_row, std::size_t width) {
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(from_row * width), width,
              to.begin() + static_cast<std::ptrdiff_t>(to_row * width));
}

template <class T>
void AppendRow(const std::vector<T>& from, std::size_t row, std::vector<T>& to, std::size_t width) {
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(row * width);
  to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
}

}  // namespace

ReplayBuffer::ReplayBuffer(const TransitionShape& shape, std::size_t capacity)
    : shape_(shape),
      capacity_(capacity),
      observations_(capacity * shape.observation_size),
      next_observations_(capacity * shape.observation_size),
      next_legal_actions_(capacity * shape.num_actions),
      extras_(capacity * shape.extras_size),
      actions_(capacity),
      rewards_(capacity),
      discounts_(capacity),
      weights_versions_(capacity) {
  RONDA_CHECK(capacity > 0, "capacity {}", capacity);
}

std::size_t ReplayBuffer::BytesPerTransition(const TransitionShape& shape) {
  return sizeof(float) * (2 * shape.observation_size + shape.extras_size + 2) + shape.num_actions +
         sizeof(std::int32_t) + sizeof(std::uint64_t);
}

std::uint64_t ReplayBuffer::Insert(const TransitionBatch& batch, std::size_t row) {
  const std::uint64_t key = next_key_++;
  const std::size_t slot = SlotOf(key);
  CopyRow(batch.observations, row, observations_, slot, shape_.observation_size);
  CopyRow(batch.next_observations, row, next_observations_, slot, shape_.observation_size);
  CopyRow(batch.next_legal_actions, row, next_legal_actions_, slot, shape_.num_actions);
  CopyRow(batch.extras, row, extras_, slot, shape_.extras_size);
  actions_[slot] = batch.actions[row];
  rewards_[slot] = batch.rewards[row];
  discounts_[slot] = batch.discounts[row];
  weights_versions_[slot] = batch.weights_versions[row];
  return key;
}

void ReplayBuffer::AppendTo(SampledBatch& to, std::uint64_t key) const {
  RONDA_CHECK(IsLive(key), "key {} of {} inserted, {} held", key, next_key_, size());
  const std::size_t slot = SlotOf(key);
  AppendRow(observations_, slot, to.observations, shape_.observation_size);
  AppendRow(next_observations_, slot, to.next_observations, shape_.observation_size);
  AppendRow(next_legal_actions_, slot, to.next_legal_actions, shape_.num_actions);
  AppendRow(extras_, slot, to.extras, shape_.extras_size);
  to.actions.push_back(actions_[slot]);
  to.rewards.push_back(rewards_[slot]);
  to.discounts.push_back(discounts_[slot]);
  to.weights_versions.push_back(weights_versions_[slot]);
  ++to.count;
}

}  // namespace ronda
