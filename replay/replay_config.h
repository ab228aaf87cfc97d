#pragma once
// [replay] of the configuration. Errors: InputError as run/config.h, and where the rate limiter
// could not work.
#include "common/run/config.h"
#include "common/run/run_config.h"
#include "replay/replay_server.h"

namespace ronda {

ReplayServerConfig ReadReplayConfig(Config& config, const RunConfig& run);

}  // namespace ronda
