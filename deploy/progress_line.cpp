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
std::string Describe(const RunStatus& status) {
  std::string line = fmt::format("{:3.0f} %", 100.0 * status.progress);
  if (status.left_s) line += fmt::format("  {} left", FormatDuration(*status.left_s));
  if (status.state == "starting") line += "  waiting for the first transitions";
  for (const std::string& problem : status.problems) line += "  " + problem;
  const std::optional<double> agi_s =
      status.curve.empty() ? std::nullopt : std::optional(status.curve.back().agi_s);
  return line + fmt::format(
                    "  AGI {} (best classical {})  {:.0f} decisions/s  {:.0f} updates/s  "
                    "replay {}/{}  {} actors",
                    Seconds(agi_s), Seconds(status.best_classical_agi_s), status.decisions_per_s,
                    status.updates_per_s, status.replay_size, status.replay_capacity,
                    status.actors_wanted);
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

void ProgressLine::Show(const RunStatus& status) {
  const auto now = Clock::now();
  if (terminal_) {
    fmt::print("\r\033[K{}", Cut(Describe(status)));
    drawn_ = true;
  } else if (now >= next_plain_) {
    next_plain_ = now + kPlainEvery;
    fmt::print("{}\n", Describe(status));
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
