#include "tests/golden/episode_text.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/expect_same_text.h"

namespace ronda::testing {
namespace {

std::string Row(std::span<const float> values) {
  std::string text;
  for (const float value : values) text += " " + Rounded(value, 2);
  return text;
}

std::string ObservationText(const Decision& decision, int row) {
  const auto values = decision.observation;
  if (row == 0) return "  sees" + Row(values) + "\n";
  std::string text;
  for (std::size_t action = 0; action < decision.legal_actions.size(); ++action) {
    if (decision.legal_actions[action] == 0) continue;
    const auto width = static_cast<std::size_t>(row);
    text += fmt::format("  sees {}:{}\n", action, Row(values.subspan(action * width, width)));
  }
  return text;
}

int RandomLegal(const Decision& decision, Rng& rng) {
  std::vector<int> legal;
  for (std::size_t action = 0; action < decision.legal_actions.size(); ++action) {
    if (decision.legal_actions[action] == 1) legal.push_back(static_cast<int>(action));
  }
  return legal[rng.Below(static_cast<std::uint32_t>(legal.size()))];
}

}  // namespace

std::string Rounded(double value, int decimals) {
  constexpr double kNoise = 1e-6;  // of a float around 1, after a few operations
  const double scale = std::pow(10.0, decimals);
  const double scaled = std::abs(value) * scale;
  const double past_middle = scaled - std::floor(scaled) - 0.5;
  INFO("too near the middle between two roundings: " << value << "; choose another seed");
  REQUIRE(std::abs(past_middle) > kNoise * scale);
  const bool is_zero = scaled < 0.5;  // never -0.000
  return fmt::format("{:.{}f}", is_zero ? 0.0 : value, decimals);
}

std::string EpisodeText(Environment& environment, const EpisodeTextOptions& options) {
  Rng actions = SplitSeed(options.seed, 1);
  environment.Reset(SplitSeed(options.seed, 0));
  std::string text;
  auto state = EpisodeState::kRunning;
  while (state == EpisodeState::kRunning) {
    const Decision& decision = environment.decision();
    text += fmt::format("{}: decision {} of agent {}, discount {}\n", options.place(decision),
                        decision.index, decision.agent, Rounded(decision.discount));
    text += ObservationText(decision, options.row);
    const int action = RandomLegal(decision, actions);
    text += fmt::format("  takes {}\n", action);
    const StepOutcome outcome = environment.Step(action);
    for (const SettledReward& settled : outcome.settled) {
      text += fmt::format("  settles decision {} of agent {}: {}\n", settled.index, settled.agent,
                          Rounded(settled.reward));
    }
    state = outcome.state;
  }
  if (state == EpisodeState::kTerminal) return text + "terminal\n";
  return text + options.place(environment.decision()) + ": cut\n";
}

void CheckKeptEpisode(const std::string& text, const std::string& name) {
  const std::string path = RONDA_SOURCE_DIR "/tests/golden/" + name;
  if (std::getenv("RONDA_REWRITE_GOLDEN") != nullptr) {
    std::ofstream(path) << text;
    WARN("wrote " << path);
    return;
  }
  std::ifstream file(path);
  const std::string kept(std::istreambuf_iterator<char>(file), {});
  ExpectSameText(text, kept, "RONDA_REWRITE_GOLDEN=1 build/release/bin/golden_test");
}

}  // namespace ronda::testing
