#include "deploy/progress_line.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "common/run/duration.h"

namespace ronda {
namespace {

constexpr std::chrono::seconds kPlainEvery{5};

std::string Seconds(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.2f} s", *seconds) : std::string("…");
}

/// What matters most comes first: a narrow terminal cuts the rest.
std::string Describe(const ProgressFigures& figures) {
  std::string line = fmt::format("{:3.0f} %", 100.0 * std::min(1.0, figures.progress));
  if (figures.left_s) line += fmt::format("  {} left", FormatDuration(*figures.left_s));
  if (!figures.waiting.empty()) line += "  " + figures.waiting;
  return line + fmt::format(
                    "  AGI {} (best classical {})  {:.0f} decisions/s  {:.0f} updates/s  "
                    "replay {}/{}  lag {:.0f} versions",
                    Seconds(figures.agi_s), Seconds(figures.best_classical_s),
                    figures.decisions_per_s, figures.updates_per_s, figures.replay_size,
                    figures.replay_capacity, figures.policy_lag_versions);
}

/// Cut to the terminal's width, so that it stays one line. Counts bytes: a little early is fine.
std::string Cut(std::string line) {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 10;
  const std::size_t width = known ? size.ws_col - 1 : 79;
  while (line.size() > width) {
    // Never in the middle of a character.
    do line.pop_back();
    while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0) == 0x80);
  }
  return line;
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDOUT_FILENO) != 0) {}

void ProgressLine::Show(const ProgressFigures& figures) {
  const auto now = Clock::now();
  if (terminal_) {
    fmt::print("\r\033[K{}", Cut(Describe(figures)));
    drawn_ = true;
  } else if (now >= next_plain_) {
    next_plain_ = now + kPlainEvery;
    fmt::print("{}\n", Describe(figures));
  }
  std::fflush(stdout);
}

void ProgressLine::Event(const std::string& text) {
  if (drawn_) fmt::print("\r\033[K");
  drawn_ = false;
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

void ProgressLine::End() {
  if (drawn_) fmt::print("\n");
  drawn_ = false;
  std::fflush(stdout);
}

}  // namespace ronda
