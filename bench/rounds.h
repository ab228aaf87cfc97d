#pragma once
// Rates of several calls measured in turn, so that a busy machine slows all of them alike.
//
// Each round gives every call its time slice; a figure is the median over the rounds, and a ratio
// is the median of the rounds' own ratios. Time is the thread's own on the processor, so that what
// else runs on the same cores counts only by what it does to caches and clock.
#include <time.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace ronda::bench {

using Rates = std::vector<double>;  // (rounds) calls a second of one call

inline double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median over the rounds of a / b.
inline double MedianRatio(const Rates& a, const Rates& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return Median(ratios);
}

inline double ThreadTime_s() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double CallsPerSecond(double slice_s, const std::function<void()>& call) {
  const double start_s = ThreadTime_s();
  double elapsed_s = 0.0;
  long calls = 0;
  do {
    for (int i = 0; i < 4; ++i) call();
    calls += 4;
    elapsed_s = ThreadTime_s() - start_s;
  } while (elapsed_s < slice_s);
  return static_cast<double>(calls) / elapsed_s;
}

/// (calls, rounds)
inline std::vector<Rates> MeasureInTurn(double slice_s, int rounds,
                                        const std::vector<std::function<void()>>& calls) {
  std::vector<Rates> rates(calls.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < calls.size(); ++i)
      rates[i].push_back(CallsPerSecond(slice_s, calls[i]));
  return rates;
}

}  // namespace ronda::bench
