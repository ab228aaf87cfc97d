#pragma once
// How a run goes, in one line: rewritten in place on a terminal, a plain line every few seconds
// elsewhere.
//
// Events (a child died) go above the line. Thread-compatible.
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace ronda {

struct ProgressFigures {
  double progress = 0.0;
  double decisions_per_s = 0.0;
  double updates_per_s = 0.0;
  std::uint64_t replay_size = 0;
  std::uint64_t replay_capacity = 0;
  double policy_lag_versions = 0.0;
  std::optional<double> agi_s;  // newest evaluation
  std::optional<double> best_classical_s;
  std::optional<double> left_s;  // of the budget
  std::string waiting;           // who waits for what; empty: nobody
};

class ProgressLine {
 public:
  ProgressLine();
  void Show(const ProgressFigures& figures);
  void Event(const std::string& text);
  void End();  // leaves the line standing

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point next_plain_;
};

}  // namespace ronda
