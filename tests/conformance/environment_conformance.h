#pragma once
// What every environment must keep (common/rl/environment.h), checked by playing episodes at
// random.
//
// Fails the running Catch2 test case where a rule is broken. Each environment's test calls it.
#include <cstdint>

#include "common/rl/environment.h"

namespace ronda {

struct ConformanceOptions {
  std::uint64_t seed = 1;
  int episodes = 2;
  int longest_episode = 1'000'000;  // decisions; an episode must have ended by then
};

void CheckEnvironmentConforms(Environment& environment, const ConformanceOptions& options = {});

}  // namespace ronda
