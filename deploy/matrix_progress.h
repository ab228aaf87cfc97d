#pragma once
// How far a comparison is, on stderr: a line that is redrawn in place on a terminal and erased at
// the end, else a line every half minute.
//
// Work is counted in decisions that are to be expected, so that a share of it takes about that
// share of the time. Thread-compatible.
#include <chrono>
#include <optional>
#include <string>

#include "common/run/every.h"
#include "deploy/screen.h"

namespace ronda {

struct MatrixStatus {
  std::size_t cells = 0;  // finished before included
  std::size_t cells_done = 0;
  double work = 0.0;  // of this call
  double work_done = 0.0;
  std::string present;  // what is played: "grid, 4 robots: er"
};

/// "3/16 cells  19 %  5 s, 21 s left  grid, 4 robots: er"; nothing is said of the time left in the
/// first second. Pure.
std::string DescribeProgress(const MatrixStatus& status, double elapsed_s);

class MatrixProgress {
 public:
  MatrixProgress();

  void Show(const MatrixStatus& status);
  /// Nothing stays on the terminal.
  void End();

 private:
  using Clock = std::chrono::steady_clock;

  Screen screen_;
  Clock::time_point begin_ = Clock::now();
  Every due_;
};

}  // namespace ronda
