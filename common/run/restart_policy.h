#pragma once
// When a process that died is started again, and when it is given up.
//
// The wait doubles with each death; a life of `healthy` or more forgets the deaths before it; the
// `most_deaths`-th death without such a life is a crash loop. A value for each process; pure, times
// are passed in.
#include <algorithm>
#include <chrono>
#include <optional>

namespace ronda {

struct RestartLimits {
  int most_deaths = 5;
  std::chrono::milliseconds healthy{10'000};
  std::chrono::milliseconds first_wait{100};
  std::chrono::milliseconds longest_wait{5'000};
};

class RestartPolicy {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit RestartPolicy(const RestartLimits& limits = {})
      : limits_(limits), wait_(limits.first_wait) {}

  /// A life that began at `started` ended at `died`. When to start the next; nullopt: give up.
  std::optional<TimePoint> Died(TimePoint started, TimePoint died) {
    if (died - started >= limits_.healthy) {
      deaths_ = 0;
      wait_ = limits_.first_wait;
    }
    if (++deaths_ >= limits_.most_deaths) return std::nullopt;
    const TimePoint next = died + wait_;
    wait_ = std::min(2 * wait_, limits_.longest_wait);
    return next;
  }

  int deaths() const { return deaths_; }  // since the last healthy life

 private:
  RestartLimits limits_;
  std::chrono::milliseconds wait_;
  int deaths_ = 0;
};

}  // namespace ronda
