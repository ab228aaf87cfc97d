#include "replay/replay_config.h"

#include <fmt/format.h>

#include "common/base/error.h"

namespace ronda {

ReplayServerConfig ReadReplayConfig(Config& config, const RunConfig& run) {
  const auto whole = [&](const char* key, std::int64_t fallback, std::int64_t most,
                         const char* doc) {
    return static_cast<std::uint64_t>(config.GetInt(key, fallback, 1, most, doc));
  };
  ReplayServerConfig replay;
  replay.shape = run.shape;
  replay.batch_size = run.batch_size;
  replay.capacity = whole("replay.capacity", 100'000, 100'000'000, "transitions held");
  replay.window =
      whole("replay.window", 1024, 1'000'000, "transitions that one actor may have on the way");
  replay.rate_limiter.min_size =
      whole("replay.min_size", 5000, 100'000'000, "transitions before the first mini-batch");
  replay.rate_limiter.samples_per_insert = config.GetDouble(
      "replay.samples_per_insert", 8.0, 1e-3, 1e6, "transitions sampled for each one inserted");
  replay.rate_limiter.error_buffer = config.GetDouble("replay.error_buffer", 65'536.0, 1.0, 1e15,
                                                      "samples that either side may run ahead");
  replay.sampler.prioritised = run.prioritised;
  replay.sampler.alpha =
      config.GetDouble("replay.alpha", 0.6, 0.0, 10.0, "exponent of the priorities");
  replay.sampler.beta =
      config.GetDouble("replay.beta", 0.4, 0.0, 1.0, "exponent of the importance weights");
  if (replay.rate_limiter.min_size > replay.capacity) {
    throw InputError(fmt::format(
        "replay.min_size: must be at most replay.capacity = {}, or nothing is ever sampled, got {}",
        replay.capacity, replay.rate_limiter.min_size));
  }
  [[maybe_unused]] const RateLimiter checked(replay.rate_limiter, run.batch_size);
  return replay;
}

}  // namespace ronda
