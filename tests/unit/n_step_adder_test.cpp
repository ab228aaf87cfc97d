#include "actor/n_step_adder.h"

#include <catch2/catch.hpp>
#include <vector>

#include "common/base/error.h"

namespace ronda {
namespace {

/// An adder whose observations are (agent, index), so that a transition says where it comes from.
class Script {
 public:
  Script(int agents, int n)
      : adder({.observation_size = 2, .num_actions = 2, .num_agents = agents}, n) {}

  Decision At(int agent, std::uint64_t index, float discount) {
    observation_ = {static_cast<float>(agent), static_cast<float>(index)};
    legal_ = {1, static_cast<std::uint8_t>(index % 2)};
    return {.agent = agent,
            .index = index,
            .observation = observation_,
            .legal_actions = legal_,
            .discount = discount};
  }
  /// Observes decision `index` and chooses action index mod 2 with weights 100 + index.
  void Decide(int agent, std::uint64_t index, float discount) {
    adder.Observe(At(agent, index, discount));
    adder.Choose(agent, static_cast<int>(index % 2), 100 + index);
  }
  std::vector<Transition> Take() {
    std::vector<Transition> taken(adder.completed().begin(), adder.completed().end());
    adder.completed().clear();
    return taken;
  }

  NStepAdder adder;

 private:
  std::vector<float> observation_;
  std::vector<std::uint8_t> legal_;
};

void Check(const Transition& transition, std::uint32_t agent, float index, float reward,
           float discount, float next_index) {
  CHECK(transition.agent == agent);
  CHECK(transition.observation == std::vector<float>{static_cast<float>(agent), index});
  CHECK(transition.action == static_cast<int>(index) % 2);
  CHECK(transition.weights_version == 100 + static_cast<std::uint64_t>(index));
  CHECK(transition.reward == Approx(reward));
  CHECK(transition.discount == Approx(discount));
  CHECK(transition.next_observation == std::vector<float>{static_cast<float>(agent), next_index});
  CHECK(transition.next_legal_actions ==
        std::vector<std::uint8_t>{1, static_cast<std::uint8_t>(static_cast<int>(next_index) % 2)});
}

TEST_CASE("One step joins what was seen, done, got and seen next") {
  Script sut(1, 1);
  sut.Decide(0, 0, 1.0f);
  sut.adder.Settle({.agent = 0, .index = 0, .reward = 3.0f});
  CHECK(sut.Take().empty());  // nothing seen next yet
  sut.Decide(0, 1, 0.9f);

  const auto transitions = sut.Take();

  REQUIRE(transitions.size() == 1);
  Check(transitions[0], 0, 0, 3.0f, 0.9f, 1);
}

TEST_CASE("Over n steps discounts multiply and each reward is discounted to the first decision") {
  Script sut(1, 3);
  const float discounts[] = {1.0f, 0.5f, 0.8f, 0.25f, 0.1f};
  for (std::uint64_t k = 0; k < 5; ++k) {
    sut.Decide(0, k, discounts[k]);
    sut.adder.Settle({.agent = 0, .index = k, .reward = 10.0f + static_cast<float>(k)});
  }

  const auto transitions = sut.Take();

  REQUIRE(transitions.size() == 2);
  Check(transitions[0], 0, 0, 10.0f + 0.5f * 11.0f + 0.4f * 12.0f, 0.5f * 0.8f * 0.25f, 3);
  Check(transitions[1], 0, 1, 11.0f + 0.8f * 12.0f + 0.2f * 13.0f, 0.8f * 0.25f * 0.1f, 4);
}

TEST_CASE("A transition waits for a reward that is settled late, and order is kept") {
  Script sut(1, 1);
  for (std::uint64_t k = 0; k < 4; ++k) sut.Decide(0, k, 0.5f);
  sut.adder.Settle({.agent = 0, .index = 1, .reward = 2.0f});
  sut.adder.Settle({.agent = 0, .index = 2, .reward = 3.0f});
  CHECK(sut.Take().empty());

  sut.adder.Settle({.agent = 0, .index = 0, .reward = 1.0f});

  const auto transitions = sut.Take();
  REQUIRE(transitions.size() == 3);
  for (int k = 0; k < 3; ++k) {
    Check(transitions[k], 0, static_cast<float>(k), 1.0f + static_cast<float>(k), 0.5f,
          static_cast<float>(k + 1));
  }
}

TEST_CASE("Agents do not mix") {
  Script sut(2, 1);
  sut.Decide(0, 0, 1.0f);
  sut.Decide(1, 0, 1.0f);
  sut.adder.Settle({.agent = 1, .index = 0, .reward = 5.0f});
  sut.Decide(1, 1, 0.7f);
  sut.adder.Settle({.agent = 0, .index = 0, .reward = 4.0f});
  sut.Decide(0, 1, 0.6f);

  const auto transitions = sut.Take();

  REQUIRE(transitions.size() == 2);
  Check(transitions[0], 1, 0, 5.0f, 0.7f, 1);
  Check(transitions[1], 0, 0, 4.0f, 0.6f, 1);
}

TEST_CASE("At a terminal state every step that is left runs to the end with discount 0") {
  Script sut(1, 3);
  for (std::uint64_t k = 0; k < 2; ++k) {
    sut.Decide(0, k, 0.5f);
    sut.adder.Settle({.agent = 0, .index = k, .reward = 1.0f + static_cast<float>(k)});
  }

  sut.adder.Finish(EpisodeState::kTerminal, {});

  const auto transitions = sut.Take();
  REQUIRE(transitions.size() == 2);
  CHECK(transitions[0].reward == Approx(1.0f + 0.5f * 2.0f));
  CHECK(transitions[1].reward == Approx(2.0f));
  for (const Transition& transition : transitions) {
    CHECK(transition.discount == 0.0f);
    CHECK(transition.next_observation == std::vector<float>{0.0f, 0.0f});
    CHECK(transition.next_legal_actions == std::vector<std::uint8_t>{1, 0});  // any one
  }
  CHECK(sut.adder.dropped() == 0);
}

TEST_CASE("At a cut what is left bootstraps from the last observation, over the steps there are") {
  Script sut(1, 3);
  for (std::uint64_t k = 0; k < 2; ++k) {
    sut.Decide(0, k, 0.5f);
    sut.adder.Settle({.agent = 0, .index = k, .reward = 1.0f + static_cast<float>(k)});
  }

  sut.adder.Finish(EpisodeState::kCut, sut.At(0, 2, 0.25f));

  const auto transitions = sut.Take();
  REQUIRE(transitions.size() == 2);
  Check(transitions[0], 0, 0, 1.0f + 0.5f * 2.0f, 0.125f, 2);
  Check(transitions[1], 0, 1, 2.0f, 0.25f, 2);
  CHECK(sut.adder.dropped() == 0);
}

TEST_CASE("At a cut a decision that is under way or was never settled makes no transition") {
  Script sut(2, 2);
  sut.Decide(1, 0, 1.0f);
  sut.adder.Settle({.agent = 1, .index = 0, .reward = 6.0f});
  sut.Decide(1, 1, 0.5f);  // under way
  sut.Decide(0, 0, 1.0f);  // never settled

  sut.adder.Finish(EpisodeState::kCut, sut.At(0, 1, 0.5f));

  const auto transitions = sut.Take();
  REQUIRE(transitions.size() == 1);
  Check(transitions[0], 1, 0, 6.0f, 0.5f, 1);
  CHECK(sut.adder.dropped() == 2);
}

TEST_CASE(
    "At a cut a decision that is settled but saw nothing after it lends only its observation") {
  Script sut(2, 2);
  for (std::uint64_t k = 0; k < 2; ++k) {
    sut.Decide(1, k, 0.5f);
    sut.adder.Settle({.agent = 1, .index = k, .reward = 6.0f});
  }

  sut.adder.Finish(EpisodeState::kCut, sut.At(0, 0, 1.0f));

  const auto transitions = sut.Take();
  REQUIRE(transitions.size() == 1);
  Check(transitions[0], 1, 0, 6.0f, 0.5f, 1);
  CHECK(sut.adder.dropped() == 1);
}

TEST_CASE("A new episode counts its decisions from 0") {
  Script sut(1, 1);
  sut.Decide(0, 0, 1.0f);
  sut.adder.Settle({.agent = 0, .index = 0, .reward = 1.0f});
  sut.adder.Finish(EpisodeState::kTerminal, {});
  sut.Decide(0, 0, 1.0f);
  sut.adder.Settle({.agent = 0, .index = 0, .reward = 2.0f});
  sut.Decide(0, 1, 0.5f);

  const auto transitions = sut.Take();

  REQUIRE(transitions.size() == 2);
  Check(transitions[1], 0, 0, 2.0f, 0.5f, 1);
}

TEST_CASE("Less than one step is refused") {
  CHECK_THROWS_WITH(NStepAdder({.observation_size = 1, .num_actions = 1}, 0),
                    "actor.n_step: must be ≥ 1, got 0");
}

}  // namespace
}  // namespace ronda
