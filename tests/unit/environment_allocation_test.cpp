// What runs once for each decision allocates nothing once it is warm. A program of its own, because
// it replaces the global operator new.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>
#include <new>

#include "common/environments/patrol_environment.h"
#include "common/world/graph_file.h"

namespace {

long allocations = 0;  // of this program, which has one thread

}  // namespace

// noinline: else the compiler sees malloc beside delete and warns of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace ronda {
namespace {

TEST_CASE("An allocation is seen by this program's counter") {
  const long before = allocations;
  const auto value = std::make_unique<int>(3);
  CHECK(*value == 3);
  CHECK(allocations > before);
}

TEST_CASE("A warm step of the patrol environment allocates nothing") {
  const auto observation = GENERATE(from_range(ObservationNames()));
  const auto reward = GENERATE(from_range(RewardNames()));
  CAPTURE(observation, reward);
  const PatrolGraph graph =
      LoadMap("cumberland", RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
  PatrolEnvironment sut(graph, ShortestPaths(graph),
                        {.agents = 10,
                         .closed_walk_m = 373.3,
                         .observation = ParseObservationScheme(observation),
                         .reward = ParseRewardScheme(reward)});
  Rng rng(1);
  sut.Reset(rng);
  const auto step = [&] {
    const auto legal = sut.decision().legal_actions;
    int action = 0;
    while (legal[action] != 1 || rng.Below(2) == 0) {
      action = (action + 1) % static_cast<int>(legal.size());
    }
    return sut.Step(action).state;
  };
  for (int i = 0; i < 100; ++i) REQUIRE(step() == EpisodeState::kRunning);

  const long before = allocations;
  bool running = true;
  for (int i = 0; i < 500; ++i) running = running && step() == EpisodeState::kRunning;
  const long after = allocations;

  CHECK(running);
  CHECK(after == before);
}

}  // namespace
}  // namespace ronda
