#pragma once
// How fast a counter grows, a second, over the last second or a little more. A counter that falls
// (its process began anew) gives 0. A value; times are passed in.
#include <algorithm>
#include <chrono>
#include <cstdint>

namespace ronda {

class RateMeter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  RateMeter(std::uint64_t count, TimePoint now) : count_(count), at_(now) {}

  void Count(std::uint64_t count, TimePoint now) {
    const std::chrono::duration<double> elapsed = now - at_;
    if (elapsed.count() < 1.0) return;
    per_s_ = static_cast<double>(count - std::min(count_, count)) / elapsed.count();
    count_ = count;
    at_ = now;
  }

  double per_s() const { return per_s_; }

 private:
  std::uint64_t count_;
  TimePoint at_;
  double per_s_ = 0.0;
};

}  // namespace ronda
