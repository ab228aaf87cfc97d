#pragma once
// How a run goes, shown to who started or watches it: a picture that is redrawn in place on a
// terminal, else a plain line every few seconds.
//
// Permanent lines (a child died) stand above the picture, or between the plain lines; a picture
// with permanent lines above it leaves some rows for them and shows no events itself. All on
// stdout. Thread-compatible.
#include <chrono>
#include <optional>
#include <string>

#include "deploy/run_status.h"
#include "deploy/screen.h"

namespace ronda {

/// A run in one line; what matters most comes first. Pure.
std::string DescribeRun(const RunStatus& status);

class RunDisplay {
 public:
  enum class Look { kLive, kPlain };  // kLive needs a terminal, else it is kPlain
  /// Where a picture has events: the caller gives them to Event, or the status has them.
  enum class Events { kAbove, kInside };

  RunDisplay(Look look, Events events)
      : screen_(look == Look::kLive), events_(events), style_(TerminalStyle()) {}

  /// Plain: at most every 5 s.
  void Show(const RunStatus& status);
  /// A permanent line, or several.
  void Event(const std::string& text);
  /// Leaves the last picture standing.
  void End() { screen_.Finish(); }

 private:
  using Clock = std::chrono::steady_clock;

  Screen screen_;
  Events events_;
  ViewStyle style_;
  Clock::time_point next_plain_;
};

}  // namespace ronda
