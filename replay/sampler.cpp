#include "replay/sampler.h"

#include <algorithm>
#include <cmath>

namespace ronda {
namespace {

void Clear(SampledBatch& batch, const TransitionShape& shape) {
  batch.shape = shape;
  batch.count = 0;
  batch.observations.clear();
  batch.actions.clear();
  batch.rewards.clear();
  batch.discounts.clear();
  batch.next_observations.clear();
  batch.next_legal_actions.clear();
  batch.extras.clear();
  batch.weights_versions.clear();
  batch.keys.clear();
  batch.importance_weights.clear();
}

}  // namespace

Sampler::Sampler(const SamplerConfig& config, std::uint64_t capacity) : config_(config) {
  if (config.prioritised) tree_.emplace(static_cast<std::size_t>(capacity));
}

void Sampler::Inserted(const ReplayBuffer& buffer, std::uint64_t key) {
  if (tree_) tree_->Set(buffer.SlotOf(key), largest_);
}

void Sampler::Update(const ReplayBuffer& buffer, const PriorityUpdate& update) {
  if (!tree_) return;
  const std::size_t count = std::min(update.keys.size(), update.priorities.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double priority = update.priorities[i];
    if (!buffer.IsLive(update.keys[i]) || !std::isfinite(priority) || priority < 0.0) continue;
    const double weight = std::pow(priority + config_.priority_floor, config_.alpha);
    largest_ = std::max(largest_, weight);
    tree_->Set(buffer.SlotOf(update.keys[i]), weight);
  }
}

void Sampler::Sample(const ReplayBuffer& buffer, std::uint32_t count, Rng& rng,
                     SampledBatch& batch) const {
  Clear(batch, buffer.shape());
  const std::uint64_t oldest = buffer.oldest_key();
  const auto size = static_cast<double>(buffer.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint64_t key = oldest + rng.Below(static_cast<std::uint32_t>(buffer.size()));
    float importance = 1.0f;
    if (tree_) {
      const std::size_t slot = tree_->Find(rng.Uniform() * tree_->total());
      const std::uint64_t oldest_slot = buffer.SlotOf(oldest);
      key = oldest + (slot + buffer.capacity() - oldest_slot) % buffer.capacity();
      const double probability = tree_->weight(slot) / tree_->total();
      importance = static_cast<float>(std::pow(size * probability, -config_.beta));
    }
    buffer.AppendTo(batch, key);
    batch.keys.push_back(key);
    batch.importance_weights.push_back(importance);
  }
  const float largest =
      *std::max_element(batch.importance_weights.begin(), batch.importance_weights.end());
  for (float& weight : batch.importance_weights) weight /= largest;
}

}  // namespace ronda
