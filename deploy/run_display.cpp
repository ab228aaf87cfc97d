#include "deploy/run_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "deploy/figures.h"

namespace ronda {
namespace {

constexpr std::chrono::seconds kPlainEvery{5};
constexpr int kRowsForEvents = 5;
constexpr int kLowScreen = 20;  // rows; below, a picture gets them all

std::string Seconds(const std::optional<double>& value) {
  return value ? Hundredths(value) + " s" : "…";
}

/// The largest of the actors'.
std::optional<double> PolicyLag(const RunStatus& status) {
  std::optional<double> lag_versions;
  for (const ProcessStatus& process : status.processes) {
    if (process.role == "actor" && process.lag_versions) {
      lag_versions = std::max(lag_versions.value_or(0.0), *process.lag_versions);
    }
  }
  return lag_versions;
}

}  // namespace

std::string DescribeRun(const RunStatus& status) {
  std::string line = Percent(status.progress);
  if (status.left_s) line += fmt::format("  {} left", ShortDuration(*status.left_s));
  if (status.state != "running") line += "  " + status.state;
  for (const std::string& problem : status.problems) line += "  " + problem;
  std::optional<double> agi_s;
  if (!status.curve.empty()) agi_s = status.curve.back().agi_s;
  line += fmt::format("  AGI {} (best classical {})  {} decisions/s  {} updates/s  replay {}/{}",
                      Seconds(agi_s), Seconds(status.best_classical_agi_s),
                      Short(status.decisions_per_s), Short(status.updates_per_s),
                      status.replay_size, status.replay_capacity);
  if (const auto lag = PolicyLag(status)) line += fmt::format("  lag {} versions", Short(*lag));
  return Harmless(line);
}

void RunDisplay::Show(const RunStatus& status) {
  if (screen_.active()) {
    ViewSize size = screen_.size();
    RunStatus shown = status;
    if (events_ == Events::kAbove) {
      shown.events.clear();
      if (size.rows >= kLowScreen) size.rows -= kRowsForEvents;
    }
    screen_.Draw(RenderRunStatus(shown, size, style_, UtcOffset(status.written_unix_s)));
  } else if (const auto now = Clock::now(); now >= next_plain_) {
    next_plain_ = now + kPlainEvery;
    fmt::print("{}\n", DescribeRun(status));
    std::fflush(stdout);
  }
}

void RunDisplay::Event(const std::string& text) {
  if (screen_.active()) {
    screen_.Print(text);
  } else {
    for (const std::string& line : HarmlessLines(text)) fmt::print("{}\n", line);
    std::fflush(stdout);
  }
}

}  // namespace ronda
