#include "replay/replay_server.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

namespace ronda {
namespace {

constexpr TransitionShape kShape{.observation_size = 2, .num_actions = 3, .extras_size = 1};
constexpr std::uint64_t kReplay = 5;

ReplayServerConfig SmallConfig() {
  ReplayServerConfig config;
  config.shape = kShape;
  config.capacity = 8;
  config.batch_size = 4;
  config.rate_limiter = {.min_size = 4, .samples_per_insert = 1e6, .error_buffer = 1e9};
  return config;
}

TransitionBatch Numbered(std::uint64_t first, std::uint32_t count) {
  TransitionBatch batch;
  batch.shape = kShape;
  batch.replay_incarnation = kReplay;
  batch.first_sequence = first;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto number = static_cast<float>(first + i);
    batch.Append({.observation = {number, -number},
                  .action = static_cast<std::int32_t>((first + i) % 3),
                  .reward = 10.0f * number,
                  .discount = 0.5f,
                  .next_observation = {number + 1, 0.0f},
                  .next_legal_actions = {1, 0, 1},
                  .extras = {number}});
  }
  return batch;
}

TransitionBatch Hello() {
  TransitionBatch batch;
  batch.shape = kShape;
  batch.replay_incarnation = kReplay;
  return batch;
}

TEST_CASE("A mini-batch holds whole transitions, none older than the capacity") {
  ReplayServer sut(SmallConfig(), kReplay, Rng(1));
  sut.Insert(Hello());
  sut.Insert(Numbered(1, 20));
  sut.Request({.learner_incarnation = 1, .first_id = 0, .end_id = 100, .batch_size = 4});

  for (int i = 0; i < 100; ++i) {
    const SampledBatch* batch = sut.NextBatch();
    REQUIRE(batch != nullptr);
    REQUIRE(batch->id == static_cast<std::uint64_t>(i));
    for (std::uint32_t row = 0; row < 4; ++row) {
      const float number = batch->observations[2 * row];
      CHECK(number >= 13.0f);
      CHECK(batch->observations[2 * row + 1] == -number);
      CHECK(batch->rewards[row] == 10.0f * number);
      CHECK(batch->actions[row] == static_cast<int>(number) % 3);
      CHECK(batch->next_observations[2 * row] == number + 1);
      CHECK(batch->extras[row] == number);
      CHECK(batch->importance_weights[row] == 1.0f);
    }
  }
  CHECK(sut.NextBatch() == nullptr);
}

TEST_CASE("Requests are cumulative: a repeated request brings nothing twice, a later one goes on") {
  ReplayServer sut(SmallConfig(), kReplay, Rng(1));
  sut.Insert(Hello());
  sut.Insert(Numbered(1, 8));

  sut.Request({.learner_incarnation = 1, .first_id = 0, .end_id = 2, .batch_size = 4});
  CHECK(sut.NextBatch()->id == 0);
  CHECK(sut.NextBatch()->id == 1);
  sut.Request({.learner_incarnation = 1, .first_id = 0, .end_id = 2, .batch_size = 4});
  CHECK(sut.NextBatch() == nullptr);
  sut.Request({.learner_incarnation = 1, .first_id = 5, .end_id = 6, .batch_size = 4});
  CHECK(sut.NextBatch()->id == 5);
  sut.Request({.learner_incarnation = 2, .first_id = 0, .end_id = 1, .batch_size = 4});
  CHECK(sut.NextBatch()->id == 0);
}

TEST_CASE("Another shape is refused, counted, and named once for each sender") {
  ReplayServer sut(SmallConfig(), kReplay, Rng(1));
  TransitionBatch batch = Hello();
  batch.shape.observation_size = 7;

  sut.Insert(batch);
  sut.Insert(batch);

  CHECK(sut.Status().messages_refused == 2);
  CHECK(sut.TakeRefusals().size() == 1);
  CHECK(sut.TakeRefusals().empty());
}

TEST_CASE("The status says which side the limiter holds") {
  ReplayServerConfig config = SmallConfig();
  config.rate_limiter = {.min_size = 4, .samples_per_insert = 1.0, .error_buffer = 8.0};
  ReplayServer sut(config, kReplay, Rng(1));
  sut.Insert(Hello());
  sut.Request({.learner_incarnation = 1, .first_id = 0, .end_id = 100, .batch_size = 4});

  CHECK(sut.NextBatch() == nullptr);
  CHECK(sut.Status().samples_wait == 1);
  sut.Insert(Numbered(1, 12));
  const ReplayStatus full = sut.Status();
  CHECK(full.inserts_wait == 1);
  CHECK(full.stored == 12);
  CHECK(full.doubled == 0);
  CHECK(sut.NextBatch() != nullptr);
}

TEST_CASE(
    "Prioritised draws follow p^alpha within five standard deviations (false alarm below 1e-5)") {
  ReplayServerConfig config = SmallConfig();
  config.sampler = {.prioritised = true, .alpha = 0.6, .beta = 1.0, .priority_floor = 1e-9};
  ReplayServer sut(config, kReplay, Rng(11));
  sut.Insert(Hello());
  sut.Insert(Numbered(1, 11));  // keys 3 … 10 are live: transitions 4 … 11
  PriorityUpdate update{.replay_incarnation = kReplay, .keys = {}, .priorities = {}};
  double total = 0.0;
  for (std::uint64_t key = 3; key <= 10; ++key) {
    update.keys.push_back(key);
    update.priorities.push_back(static_cast<float>(key));
    total += std::pow(static_cast<double>(key), 0.6);
  }
  sut.Reprioritise(update);
  constexpr int kBatches = 25'000;
  sut.Request({.learner_incarnation = 1, .first_id = 0, .end_id = kBatches, .batch_size = 4});

  std::map<std::uint64_t, int> counts;
  for (int i = 0; i < kBatches; ++i) {
    const SampledBatch* batch = sut.NextBatch();
    REQUIRE(batch != nullptr);
    for (std::uint32_t row = 0; row < 4; ++row) {
      ++counts[batch->keys[row]];
      CHECK(batch->observations[2 * row] == static_cast<float>(batch->keys[row] + 1));
    }
  }
  for (std::uint64_t key = 3; key <= 10; ++key) {
    const double probability = std::pow(static_cast<double>(key), 0.6) / total;
    const double draws = 4.0 * kBatches;
    const double deviation = std::sqrt(draws * probability * (1 - probability));
    CHECK(std::abs(counts[key] - draws * probability) < 5.0 * deviation);
  }
}

}  // namespace
}  // namespace ronda
