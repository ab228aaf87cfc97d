#pragma once
// The wall clock, for what people and other processes read; durations are measured by steady_clock.
#include <chrono>

namespace ronda {

/// Seconds since 1970-01-01 00:00 UTC.
inline double UnixNow() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace ronda
