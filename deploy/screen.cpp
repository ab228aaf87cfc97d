#include "deploy/screen.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace ronda {
namespace {

constexpr const char* kHideCursor = "\x1b[?25l";
constexpr const char* kShowCursor = "\x1b[?25h";
constexpr const char* kEraseRestOfLine = "\x1b[K";
constexpr const char* kEraseBelow = "\x1b[J";

bool CanDraw(int output) {
  const char* term = std::getenv("TERM");
  return isatty(output) != 0 && term != nullptr && *term != '\0' &&
         std::string_view(term) != "dumb";
}

ViewSize TerminalSize(int output) {
  winsize size{};
  if (ioctl(output, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {.columns = size.ws_col, .rows = size.ws_row};
}

/// Rows that lines take on a terminal of that many columns, folded where they are wider.
int RowsOf(const std::vector<std::string>& lines, int columns) {
  int rows = 0;
  for (const std::string& line : lines) {
    rows += std::max(1, (DisplayColumns(line) + columns - 1) / columns);
  }
  return rows;
}

bool Writable(int output) {
  pollfd watched{output, POLLOUT, 0};
  return ::poll(&watched, 1, 0) == 1;
}

}  // namespace

Screen::Screen(bool wanted, int output) : output_(output), active_(wanted && CanDraw(output)) {}

ViewSize Screen::size() const {
  const ViewSize terminal = TerminalSize(output_);
  return {.columns = std::max(1, terminal.columns - 1), .rows = std::max(1, terminal.rows - 1)};
}

void Screen::Draw(std::vector<std::string> lines) {
  if (!active_) return;
  wanted_ = std::move(lines);
  if (Writable(output_)) Paint();
}

void Screen::Print(std::string_view text) {
  if (!active_) return;
  for (const std::string& line : HarmlessLines(text)) pending_ += line + "\r\n";
  if (Writable(output_)) Paint();
}

void Screen::Paint() {
  std::fflush(stdout);
  std::string bytes = std::exchange(cursor_hidden_, true) ? "\r" : kHideCursor + std::string("\r");
  const int rows = RowsOf(drawn_, TerminalSize(output_).columns);
  if (rows > 0) bytes += fmt::format("\x1b[{}A", rows);
  // Permanent lines may be folded, which leaves no place to erase to the right of them.
  if (!pending_.empty()) bytes += kEraseBelow + std::exchange(pending_, {});
  for (const std::string& line : wanted_) bytes += line + kEraseRestOfLine + "\r\n";
  drawn_ = wanted_;
  Write(bytes + kEraseBelow);
}

void Screen::Finish() {
  if (!active_) return;
  if (!pending_.empty()) Paint();
  if (!cursor_hidden_) return;
  wanted_.clear();
  drawn_.clear();
  cursor_hidden_ = false;
  Write(kShowCursor);
}

void Screen::Write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(output_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      pollfd watched{output_, POLLOUT, 0};
      ::poll(&watched, 1, -1);
    } else if (errno != EINTR) {
      active_ = false;
      return;
    }
  }
}

ViewStyle TerminalStyle() {
  const char* no_colour = std::getenv("NO_COLOR");
  return no_colour != nullptr && *no_colour != '\0' ? ViewStyle::kPlain : ViewStyle::kColour;
}

int UtcOffset(double unix_s) {
  const auto moment = static_cast<std::time_t>(unix_s);
  std::tm local{};
  return localtime_r(&moment, &local) == nullptr ? 0 : static_cast<int>(local.tm_gmtoff);
}

}  // namespace ronda
