#pragma once
// An episode of any environment as text that can be read and kept: for each decision what the
// environment says has happened, the observation, the action (drawn at random from `seed`, among
// the legal ones) and the rewards that it settled.
//
// Times, discounts and rewards have three decimals, observations two. A number so near the middle
// between two that another machine could print the other one fails the test: choose another seed.
// Kept episodes are files in tests/golden; RONDA_REWRITE_GOLDEN=1 makes CheckKeptEpisode write
// instead of compare. After OpenSpiel's playthroughs (Lanctot et al. 2019).
#include <cstdint>
#include <functional>
#include <string>

#include "common/rl/environment.h"

namespace ronda::testing {

struct EpisodeTextOptions {
  std::uint64_t seed = 1;
  int row = 0;  // numbers of an observation in a line; where the action of its index is not legal,
                // the line is left out. 0: all in one line
  /// "3.000 s, robot 0 at 2": where the environment stands, asked once for each decision.
  std::function<std::string(const Decision&)> place;
};

std::string EpisodeText(Environment& environment, const EpisodeTextOptions& options);

/// Fails the test where a few roundings of a float could change the last decimal.
std::string Rounded(double value, int decimals = 3);

/// Compares `text` with tests/golden/`name`.
void CheckKeptEpisode(const std::string& text, const std::string& name);

}  // namespace ronda::testing
