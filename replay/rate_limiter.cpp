#include "replay/rate_limiter.h"

#include <fmt/format.h>

#include "common/base/error.h"

namespace ronda {

RateLimiter::RateLimiter(const RateLimiterConfig& config, std::uint64_t batch_size)
    : config_(config) {
  // Half of the band (2 · error_buffer) may be promised to actors that have not used it yet.
  const double needed = config.samples_per_insert + static_cast<double>(batch_size);
  if (config.error_buffer < needed) {
    throw InputError(
        fmt::format("replay.error_buffer: must be at least samples_per_insert + batch size = {} "
                    "samples, or actors and "
                    "learner would wait for each other, got {}",
                    needed, config.error_buffer));
  }
}

std::uint64_t RateLimiter::InsertRoom() const {
  const double target = static_cast<double>(config_.min_size) * config_.samples_per_insert;
  const double most =
      (target + config_.error_buffer + static_cast<double>(sampled_)) / config_.samples_per_insert;
  const double room = most - static_cast<double>(inserted_);
  return room > 0.0 ? static_cast<std::uint64_t>(room) : 0;
}

bool RateLimiter::CanSample(std::uint64_t count, std::uint64_t size) const {
  const double target = static_cast<double>(config_.min_size) * config_.samples_per_insert;
  const double difference =
      static_cast<double>(inserted_) * config_.samples_per_insert - static_cast<double>(sampled_);
  return size >= config_.min_size && size > 0 &&
         difference - static_cast<double>(count) >= target - config_.error_buffer;
}

}  // namespace ronda
