#pragma once
// What several decoders check. Private to common/dds. Pure.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/rl/transition.h"

namespace ronda::dds {

inline bool AllFinite(const std::vector<float>& values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

template <typename T>
bool HasSize(const std::vector<T>& values, std::uint64_t rows, std::uint64_t width = 1) {
  return values.size() == rows * width;
}

/// The arrays that transitions and mini-batches share: sizes, ranges and finiteness of `count`
/// rows.
template <typename Message>
bool RowsFit(const Message& message) {
  const std::uint64_t rows = message.count();
  return HasSize(message.observations(), rows, message.observation_size()) &&
         HasSize(message.next_observations(), rows, message.observation_size()) &&
         HasSize(message.next_legal_actions(), rows, message.num_actions()) &&
         HasSize(message.extras(), rows, message.extras_size()) &&
         HasSize(message.actions(), rows) && HasSize(message.rewards(), rows) &&
         HasSize(message.discounts(), rows) && HasSize(message.weights_versions(), rows);
}

template <typename Message>
bool RowsInRange(const Message& message) {
  const auto& legal = message.next_legal_actions();
  const std::size_t width = message.num_actions();
  for (std::size_t row = 0; row < message.count(); ++row) {
    const std::int32_t action = message.actions()[row];
    const float discount = message.discounts()[row];
    if (action < 0 || static_cast<std::uint32_t>(action) >= width) return false;
    if (!(discount >= 0.0f && discount <= 1.0f)) return false;
    const auto begin = legal.begin() + static_cast<std::ptrdiff_t>(row * width);
    const auto end = begin + static_cast<std::ptrdiff_t>(width);
    if (std::any_of(begin, end, [](std::uint8_t flag) { return flag > 1; })) return false;
    if (std::none_of(begin, end, [](std::uint8_t flag) { return flag == 1; })) return false;
  }
  return true;
}

template <typename Message>
bool RowsFinite(const Message& message) {
  return AllFinite(message.observations()) && AllFinite(message.next_observations()) &&
         AllFinite(message.rewards()) && AllFinite(message.extras());
}

/// Copies the shared arrays, in either direction's accessor style.
template <typename Message, typename Value>
void RowsToMessage(const Value& value, Message& message) {
  message.observation_size(value.shape.observation_size);
  message.num_actions(value.shape.num_actions);
  message.extras_size(value.shape.extras_size);
  message.count(value.count);
  message.observations(value.observations);
  message.actions(value.actions);
  message.rewards(value.rewards);
  message.discounts(value.discounts);
  message.next_observations(value.next_observations);
  message.next_legal_actions(value.next_legal_actions);
  message.extras(value.extras);
  message.weights_versions(value.weights_versions);
}

template <typename Message, typename Value>
void RowsToValue(const Message& message, Value& value) {
  value.shape = {.observation_size = message.observation_size(),
                 .num_actions = message.num_actions(),
                 .extras_size = message.extras_size()};
  value.count = message.count();
  value.observations = message.observations();
  value.actions = message.actions();
  value.rewards = message.rewards();
  value.discounts = message.discounts();
  value.next_observations = message.next_observations();
  value.next_legal_actions = message.next_legal_actions();
  value.extras = message.extras();
  value.weights_versions = message.weights_versions();
}

}  // namespace ronda::dds
