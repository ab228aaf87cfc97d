// What runs once for each update or decision allocates nothing once it is warm. A program of its
// own, because it replaces the global operator new.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>
#include <vector>

#include "common/policies/q_policy.h"
#include "learner/dqn.h"
#include "tests/unit/gradient_check.h"

namespace {

long allocations = 0;  // of this program, which has one thread

}  // namespace

// noinline: else the compiler sees malloc beside delete and warns of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}

namespace ronda {
namespace {

using testing::RandomVector;

constexpr std::uint32_t kBatch = 9;

NetworkSpec Spec(NetworkSpec::Kind kind) {
  return {.kind = kind,
          .observation_size = 12,
          .num_actions = 3,
          .features = 4,
          .hidden = {16, 8},
          .layer_norm = true,
          .schema = "test"};
}

TEST_CASE("An allocation is seen by this program's counter") {
  const long before = allocations;
  const std::vector<int> memory(100);
  CHECK(memory.size() == 100);
  CHECK(allocations == before + 1);
}

TEST_CASE("A warm update allocates nothing") {
  for (const auto kind : {NetworkSpec::Kind::kCandidateScorer, NetworkSpec::Kind::kMlp}) {
    Rng rng(41);
    SampledBatch batch;
    batch.shape = {.observation_size = 12, .num_actions = 3};
    batch.count = kBatch;
    batch.observations = RandomVector<float>(rng, kBatch * 12);
    batch.next_observations = RandomVector<float>(rng, kBatch * 12);
    batch.actions.assign(kBatch, 1);
    batch.rewards.assign(kBatch, 1.0f);
    batch.discounts.assign(kBatch, 0.9f);
    batch.next_legal_actions.assign(kBatch * 3, 1);
    batch.importance_weights.assign(kBatch, 1.0f);
    Dqn sut({.network = Spec(kind), .target_interval = 2});
    for (int i = 0; i < 3; ++i) sut.Update(batch);
    const long before = allocations;

    for (int i = 0; i < 3; ++i) sut.Update(batch);

    CHECK(allocations == before);
  }
}

TEST_CASE("A warm decision allocates nothing") {
  Rng rng(42);
  QPolicy sut(Spec(NetworkSpec::Kind::kCandidateScorer));
  const auto observation = RandomVector<float>(rng, 12);
  const std::vector<std::uint8_t> all{1, 1, 1}, one{0, 1, 0};
  sut.Act(observation, all);
  const long before = allocations;

  sut.Act(observation, one);
  sut.Act(observation, all);

  CHECK(allocations == before);
}

}  // namespace
}  // namespace ronda
