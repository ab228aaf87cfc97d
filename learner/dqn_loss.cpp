#include "learner/dqn_loss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

/// The floats themselves, or a copy as doubles in `memory`.
template <typename Scalar>
std::span<const Scalar> As(const std::vector<float>& values, std::vector<Scalar>& memory) {
  if constexpr (std::is_same_v<Scalar, float>) {
    return values;
  } else {
    memory.assign(values.begin(), values.end());
    return memory;
  }
}

}  // namespace

template <typename Scalar>
DqnLoss<Scalar>::DqnLoss(const NetworkSpec& spec, const DqnLossConfig& config)
    : config_(config), network_(spec) {}

template <typename Scalar>
void DqnLoss<Scalar>::CheckBatch(const SampledBatch& batch) const {
  const NetworkSpec& spec = network_.spec();
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("mini-batch {}: {}", batch.id, why));
  };
  if (batch.shape.observation_size != static_cast<std::uint32_t>(spec.observation_size) ||
      batch.shape.num_actions != static_cast<std::uint32_t>(spec.num_actions))
    refuse(fmt::format("observations of {} and {} actions, but the network reads {} and {}",
                       batch.shape.observation_size, batch.shape.num_actions, spec.observation_size,
                       spec.num_actions));
  const std::size_t count = batch.count;
  const std::size_t observations = count * batch.shape.observation_size;
  const std::size_t num_actions = batch.shape.num_actions;
  if (count == 0 || batch.observations.size() != observations ||
      batch.next_observations.size() != observations || batch.actions.size() != count ||
      batch.rewards.size() != count || batch.discounts.size() != count ||
      batch.next_legal_actions.size() != count * num_actions ||
      batch.importance_weights.size() != count)
    refuse(fmt::format("the arrays' lengths do not fit {} transitions", count));
  for (std::size_t i = 0; i < count; ++i) {
    if (batch.actions[i] < 0 || batch.actions[i] >= spec.num_actions)
      refuse(fmt::format("transition {} has action {} of {}", i, batch.actions[i], num_actions));
    const auto* const legal = batch.next_legal_actions.data() + i * num_actions;
    if (batch.discounts[i] != 0.0f &&
        std::all_of(legal, legal + num_actions, [](auto l) { return l == 0; }))
      refuse(fmt::format("transition {} has discount {} and no legal next action", i,
                         batch.discounts[i]));
  }
}

template <typename Scalar>
void DqnLoss<Scalar>::ComputeTargets(std::span<const Scalar> online, std::span<const Scalar> target,
                                     const SampledBatch& batch) {
  const std::size_t count = batch.count;
  const std::size_t num_actions = batch.shape.num_actions;
  const auto next = As(batch.next_observations, next_observations_);
  next_legal_ = batch.next_legal_actions;
  for (std::size_t i = 0; i < count; ++i)
    if (batch.discounts[i] == 0.0f)
      std::fill_n(next_legal_.begin() + static_cast<std::ptrdiff_t>(i * num_actions), num_actions,
                  std::uint8_t{0});
  next_q_.resize(count * num_actions);
  network_.Forward(config_.double_q ? online : target, next, next_legal_, workspace_, next_q_);
  next_actions_.assign(count, QNetwork<Scalar>::kNoAction);
  next_values_.assign(count, Scalar(0));
  for (std::size_t i = 0; i < count; ++i) {
    if (batch.discounts[i] == 0.0f) continue;
    const Scalar* const q = next_q_.data() + i * num_actions;
    const auto best = std::max_element(q, q + num_actions);
    next_actions_[i] = static_cast<std::int32_t>(best - q);
    next_values_[i] = *best;
  }
  if (config_.double_q)
    network_.ForwardChosen(target, next, next_actions_, workspace_, next_values_);
  targets_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    targets_[i] =
        static_cast<Scalar>(batch.rewards[i]) +
        (batch.discounts[i] == 0.0f ? Scalar(0)
                                    : static_cast<Scalar>(batch.discounts[i]) * next_values_[i]);
}

template <typename Scalar>
auto DqnLoss<Scalar>::Evaluate(std::span<const Scalar> online, std::span<const Scalar> target,
                               const SampledBatch& batch, std::span<Scalar> gradient) -> Result {
  CheckBatch(batch);
  ComputeTargets(online, target, batch);
  const std::size_t count = batch.count;
  q_.resize(count);
  slopes_.resize(count);
  absolute_td_.resize(count);
  network_.ForwardChosen(online, As(batch.observations, observations_), batch.actions, workspace_,
                         q_);
  const Scalar share = Scalar(1) / static_cast<Scalar>(count);
  Result result;
  for (std::size_t i = 0; i < count; ++i) {
    const Scalar error = q_[i] - targets_[i];
    const Scalar weight = share * static_cast<Scalar>(batch.importance_weights[i]);
    const auto loss = Loss(config_.loss, error, static_cast<Scalar>(config_.huber_delta));
    // L = Σ w/B · loss(q − y)   ⇒   ∂L/∂q = w/B · loss'(q − y)
    slopes_[i] = weight * loss.slope;
    absolute_td_[i] = static_cast<float>(std::abs(error));
    result.loss += static_cast<double>(weight * loss.value);
    result.mean_absolute_td += static_cast<double>(share * std::abs(error));
    result.mean_q += static_cast<double>(share * q_[i]);
  }
  std::fill(gradient.begin(), gradient.end(), Scalar(0));
  network_.BackwardChosen(online, batch.actions, slopes_, workspace_, gradient);
  return result;
}

template class DqnLoss<float>;
template class DqnLoss<double>;

}  // namespace ronda
