#pragma once
// [replay] of the configuration. Errors: InputError as run/config.h, and where the rate limiter
// could not work.
#include "common/run/config.h"
#include "common/run/run_config.h"
#include "replay/replay_server.h"

namespace ronda {

/// `batch_size` is the learner's.
ReplayServerConfig ReadReplayConfig(Config& config, const RunConfig& run, std::uint32_t batch_size);

}  // namespace ronda
