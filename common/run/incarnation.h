#pragma once
// A number for the start of a process: larger for every later start on this machine.
#include <chrono>
#include <cstdint>

namespace ronda {

/// Microseconds since 1970.
inline std::uint64_t NewIncarnation() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

}  // namespace ronda
