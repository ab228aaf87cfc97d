#pragma once
// How a run goes, in one line: rewritten in place on a terminal, a plain line every few seconds
// elsewhere.
//
// Events (a child died) go above the line. Thread-compatible.
#include <chrono>
#include <string>

#include "deploy/run_status.h"

namespace ronda {

class ProgressLine {
 public:
  ProgressLine();
  void Show(const RunStatus& status);
  void Event(const std::string& text);
  void End();  // leaves the line standing

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point next_plain_;
};

}  // namespace ronda
