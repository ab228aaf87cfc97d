#include "deploy/matrix_progress.h"

#include <fmt/format.h>

#include <cstdio>

#include "deploy/figures.h"

namespace ronda {
namespace {

constexpr std::chrono::milliseconds kDrawEvery{100};
constexpr std::chrono::seconds kPlainEvery{30};
constexpr double kSettled_s = 1.0;

}  // namespace

std::string DescribeProgress(const MatrixStatus& status, double elapsed_s) {
  const double share = status.work > 0.0 ? status.work_done / status.work : 1.0;
  std::string line = fmt::format("{}/{} cells  {}  {}", status.cells_done, status.cells,
                                 Percent(share), ShortDuration(elapsed_s));
  if (elapsed_s >= kSettled_s && share > 0.0) {
    line += fmt::format(", {} left", ShortDuration(elapsed_s * (1.0 - share) / share));
  }
  return Harmless(line + "  " + status.present);
}

MatrixProgress::MatrixProgress()
    : screen_(true, STDERR_FILENO), due_(screen_.active() ? kDrawEvery : kPlainEvery) {
  if (!screen_.active()) due_.Due(begin_);  // the first plain line comes after a while
}

void MatrixProgress::Show(const MatrixStatus& status) {
  const Clock::time_point now = Clock::now();
  if (!due_.Due(now)) return;
  const std::string line =
      DescribeProgress(status, std::chrono::duration<double>(now - begin_).count());
  if (screen_.active()) {
    screen_.Draw({Cut(line, screen_.size().columns)});
  } else {
    fmt::print(stderr, "{}\n", line);
  }
}

void MatrixProgress::End() {
  screen_.Draw({});
  screen_.Finish();
}

}  // namespace ronda
