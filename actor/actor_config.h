#pragma once
// `reward`, `observation` and what goes with them, [environment], [conditions], [exploration] and
// [actor] of the configuration. Errors: InputError as run/config.h.
#include <chrono>

#include "actor/exploration.h"
#include "common/environments/patrol_environment.h"
#include "common/run/config.h"
#include "common/run/run_config.h"

namespace ronda {

struct ActorConfig {
  PatrolEnvironmentOptions environment;  // closed_walk_m is the map's: the caller sets it
  ExplorationOptions exploration;
  int n_steps = 1;
  std::uint32_t batch_size = 256;  // transitions in a message
  std::chrono::milliseconds max_age{10};
};

ActorConfig ReadActorConfig(Config& config, const RunConfig& run);

}  // namespace ronda
