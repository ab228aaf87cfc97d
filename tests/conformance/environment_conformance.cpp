#include "tests/conformance/environment_conformance.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

namespace ronda {
namespace {

/// All that an episode shows, as bytes, and what of it is counted.
struct Episode {
  std::string bytes;
  std::uint64_t decisions = 0;
  std::uint64_t settled = 0;
};

template <typename Value>
void Append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// What has been decided and settled so far in one episode.
class Books {
 public:
  explicit Books(const EnvironmentSpec& spec)
      : spec_(spec), decided_(spec.num_agents, 0), settled_(spec.num_agents) {}

  void Check(const Decision& decision) {
    REQUIRE(decision.agent >= 0);
    REQUIRE(decision.agent < spec_.num_agents);
    REQUIRE(decision.index == decided_[decision.agent]++);
    REQUIRE(static_cast<int>(decision.observation.size()) == spec_.observation_size);
    REQUIRE(static_cast<int>(decision.legal_actions.size()) == spec_.num_actions);
    REQUIRE(std::all_of(decision.observation.begin(), decision.observation.end(),
                        [](float value) { return std::isfinite(value); }));
    REQUIRE(std::all_of(decision.legal_actions.begin(), decision.legal_actions.end(),
                        [](std::uint8_t legal) { return legal <= 1; }));
    REQUIRE(std::count(decision.legal_actions.begin(), decision.legal_actions.end(), 1) >= 1);
    REQUIRE(decision.discount > 0.0f);
    REQUIRE(decision.discount <= 1.0f);
    if (decision.index == 0) REQUIRE(decision.discount == 1.0f);
  }

  void Check(const SettledReward& settled) {
    REQUIRE(settled.agent >= 0);
    REQUIRE(settled.agent < spec_.num_agents);
    REQUIRE(settled.index < decided_[settled.agent]);
    REQUIRE(std::isfinite(settled.reward));
    REQUIRE(settled_[settled.agent].insert(settled.index).second);  // once
  }

  /// Whoever was asked again has its decisions before settled by the end of the episode; what it
  /// decided last may have been under way.
  void CheckEnd() const {
    for (int agent = 0; agent < spec_.num_agents; ++agent) {
      const auto answered = decided_[agent] > 0 ? decided_[agent] - 1 : 0;
      REQUIRE(settled_[agent].size() >= answered);
    }
  }

 private:
  EnvironmentSpec spec_;
  std::vector<std::uint64_t> decided_;            // (N)
  std::vector<std::set<std::uint64_t>> settled_;  // (N)
};

void Record(Episode& episode, const Decision& decision) {
  Append(episode.bytes, decision.agent);
  Append(episode.bytes, decision.index);
  Append(episode.bytes, decision.discount);
  for (const float value : decision.observation) Append(episode.bytes, value);
  for (const std::uint8_t legal : decision.legal_actions) Append(episode.bytes, legal);
}

int RandomLegal(const Decision& decision, Rng& rng) {
  std::vector<int> legal;
  for (std::size_t a = 0; a < decision.legal_actions.size(); ++a) {
    if (decision.legal_actions[a] == 1) legal.push_back(static_cast<int>(a));
  }
  return legal[rng.Below(static_cast<std::uint32_t>(legal.size()))];
}

Episode Play(Environment& environment, const Rng& world_rng, Rng action_rng, int longest_episode) {
  Episode episode;
  Books books(environment.spec());
  environment.Reset(world_rng);
  auto state = EpisodeState::kRunning;
  books.Check(environment.decision());
  Record(episode, environment.decision());
  while (state == EpisodeState::kRunning) {
    REQUIRE(episode.decisions < static_cast<std::uint64_t>(longest_episode));
    const StepOutcome outcome = environment.Step(RandomLegal(environment.decision(), action_rng));
    state = outcome.state;
    ++episode.decisions;
    for (const SettledReward& settled : outcome.settled) {
      books.Check(settled);
      Append(episode.bytes, settled.agent);
      Append(episode.bytes, settled.index);
      Append(episode.bytes, settled.reward);
      ++episode.settled;
    }
    if (state == EpisodeState::kTerminal) break;
    books.Check(environment.decision());
    Record(episode, environment.decision());
  }
  books.CheckEnd();
  return episode;
}

}  // namespace

void CheckEnvironmentConforms(Environment& environment, const ConformanceOptions& options) {
  REQUIRE(environment.spec().observation_size > 0);
  REQUIRE(environment.spec().num_actions > 0);
  REQUIRE(environment.spec().num_agents > 0);
  std::vector<Episode> episodes;
  for (int i = 0; i < options.episodes; ++i) {
    const Rng world_rng = SplitSeed(options.seed, 2 * i);
    const Rng action_rng = SplitSeed(options.seed, 2 * i + 1);
    INFO("seed " << options.seed << ", episode " << i);
    episodes.push_back(Play(environment, world_rng, action_rng, options.longest_episode));
    REQUIRE(episodes.back().decisions > 0);
    REQUIRE(episodes.back().settled > 0);
  }
  // What came before leaves no trace: the first episode again, byte for byte.
  const Episode again = Play(environment, SplitSeed(options.seed, 0), SplitSeed(options.seed, 1),
                             options.longest_episode);
  REQUIRE(again.bytes == episodes.front().bytes);
  if (episodes.size() > 1) {
    INFO("another seed must give another episode");
    REQUIRE(episodes[1].bytes != episodes[0].bytes);
  }
}

}  // namespace ronda
