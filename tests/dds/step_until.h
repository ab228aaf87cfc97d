#pragma once
// Calls `step`, which itself waits for what may come, until `condition` holds; false where it does
// not within the limit, which is far above what is needed.
#include <chrono>

namespace ronda {

template <typename Step, typename Condition>
bool StepUntil(Step step, Condition condition,
               std::chrono::seconds at_most = std::chrono::seconds(60)) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= deadline) return false;
    step();
  }
  return true;
}

}  // namespace ronda
