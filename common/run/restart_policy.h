#pragma once
// When a child that died is started again, and when it is given up.
//
// The wait doubles from 0.1 s to 5 s with each death and is forgotten after 10 healthy seconds; 5
// deaths without 10 healthy seconds between them are a crash loop. A value; times are passed in.
#include <algorithm>
#include <chrono>
#include <optional>

namespace ronda {

class RestartPolicy {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  static constexpr int kMostDeaths = 5;
  static constexpr std::chrono::seconds kHealthy{10};

  /// A start at `started` ended at `died`. When to start again; nullopt: give up.
  std::optional<TimePoint> Died(TimePoint started, TimePoint died) {
    if (died - started >= kHealthy) deaths_ = 0;
    if (++deaths_ >= kMostDeaths) return std::nullopt;
    const auto wait = std::chrono::milliseconds(100) * (1 << (deaths_ - 1));
    return died + std::min<std::chrono::milliseconds>(wait, std::chrono::seconds(5));
  }

  int deaths() const { return deaths_; }

 private:
  int deaths_ = 0;
};

}  // namespace ronda
