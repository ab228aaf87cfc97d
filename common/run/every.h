#pragma once
// Something that is due every so often. A value; times are passed in.
#include <chrono>

namespace ronda {

class Every {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit Every(std::chrono::milliseconds period) : period_(period) {}

  /// True the first time, and then once a period; what was missed is not made up.
  bool Due(TimePoint now) {
    if (now < next_) return false;
    next_ = now + period_;
    return true;
  }

 private:
  std::chrono::milliseconds period_;
  TimePoint next_{};
};

}  // namespace ronda
