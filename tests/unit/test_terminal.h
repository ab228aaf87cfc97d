#pragma once
// A pseudo-terminal and what a person sees on it: understands exactly the sequences that Screen
// sends, aborts at any other. Where the width shrinks, lines are folded as most terminals do.
// Thread-compatible.
#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "common/base/check.h"
#include "common/base/file_descriptor.h"

namespace ronda {

class TestTerminal {
 public:
  TestTerminal(int columns, int rows) : columns_(columns), rows_(rows), lines_(1) {
    int master = -1, slave = -1;
    RONDA_CHECK(::openpty(&master, &slave, nullptr, nullptr, nullptr) == 0, "openpty");
    master_ = FileDescriptor(master);
    slave_ = FileDescriptor(slave);
    SetSize();
  }

  int output() const { return slave_.number(); }
  void Pause() { RONDA_CHECK(::tcflow(output(), TCOOFF) == 0, "tcflow"); }
  void Continue() { RONDA_CHECK(::tcflow(output(), TCOON) == 0, "tcflow"); }
  void HangUp() { master_.Close(); }

  /// The lines above the cursor are folded anew.
  void Resize(int columns, int rows) {
    Receive();
    std::vector<std::string> folded;
    for (const std::string& line : lines_) {
      for (std::size_t at = 0; at == 0 || at < line.size();
           at += static_cast<std::size_t>(columns)) {
        folded.push_back(line.substr(at, static_cast<std::size_t>(columns)));
      }
    }
    lines_ = std::move(folded);
    row_ = lines_.size() - 1;
    columns_ = columns;
    rows_ = rows;
    SetSize();
  }

  /// Everything from the beginning, what has scrolled away too; without empty lines at the end.
  std::vector<std::string> Lines() {
    Receive();
    std::vector<std::string> lines = lines_;
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
  }
  bool cursor_hidden() {
    Receive();
    return cursor_hidden_;
  }
  /// All bytes so far.
  const std::string& bytes() {
    Receive();
    return bytes_;
  }
  std::size_t cursor_row() {
    Receive();
    return row_;
  }

 private:
  void SetSize() {
    const winsize size{static_cast<unsigned short>(rows_), static_cast<unsigned short>(columns_), 0,
                       0};
    RONDA_CHECK(::ioctl(output(), TIOCSWINSZ, &size) == 0, "TIOCSWINSZ");
  }

  /// A byte that nobody else sends marks the end of what has been sent.
  void Receive() {
    constexpr char kMark = '\x05';
    RONDA_CHECK(::write(output(), &kMark, 1) == 1, "write");
    std::string arrived;
    for (char byte = 0; ::read(master_.number(), &byte, 1) == 1 && byte != kMark;) arrived += byte;
    bytes_ += arrived;
    for (std::size_t at = 0; at < arrived.size();) at += Take(arrived, at);
  }

  /// The bytes of one character or sequence, after doing what it says.
  std::size_t Take(const std::string& text, std::size_t at) {
    if (text[at] == '\x1b') return TakeSequence(text, at);
    if (text[at] == '\r') {
      column_ = 0;
    } else if (text[at] == '\n') {
      if (++row_ == lines_.size()) lines_.emplace_back();
    } else {
      if (column_ == static_cast<std::size_t>(columns_)) Take("\r\n", 0), Take("\n", 0);
      lines_[row_].resize(std::max(lines_[row_].size(), column_ + 1), ' ');
      lines_[row_][column_++] = text[at];
    }
    return 1;
  }

  std::size_t TakeSequence(const std::string& text, std::size_t at) {
    const std::size_t end = text.find_first_not_of("0123456789?;", at + 2);
    const std::string sequence = text.substr(at + 1, end - at);
    if (sequence == "[?25l" || sequence == "[?25h") {
      cursor_hidden_ = sequence.back() == 'l';
    } else if (sequence == "[K") {
      lines_[row_].resize(std::min(lines_[row_].size(), column_));
    } else if (sequence == "[J") {
      lines_.resize(row_ + 1);
      lines_[row_].resize(std::min(lines_[row_].size(), column_));
    } else if (sequence.back() == 'A') {
      // No higher than the first row of the screen.
      const std::size_t top = lines_.size() - std::min(lines_.size(), std::size_t(rows_));
      const std::size_t up = std::stoul(sequence.substr(1));
      row_ = std::max(top, row_ - std::min(row_, up));
    } else {
      RONDA_CHECK(false, "sequence {}", sequence);
    }
    return end + 1 - at;
  }

  int columns_;
  int rows_;
  FileDescriptor master_;
  FileDescriptor slave_;
  std::string bytes_;
  std::vector<std::string> lines_;  // one byte a column
  std::size_t row_ = 0;
  std::size_t column_ = 0;
  bool cursor_hidden_ = false;
};

}  // namespace ronda
