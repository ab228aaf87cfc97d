#pragma once
// A picture of a few lines that is drawn over itself on a terminal, and permanent lines above it.
//
// Active only where it is wanted, the output is a terminal and TERM is set and not "dumb"; else
// nothing is ever written. Each drawing is one write of plain ECMA-48 sequences (cursor up, erase
// line, erase below): the picture only ever grows downwards, which needs no library.
// A new size counts from the next drawing on. Terminals fold the lines of a picture that no longer
// fits their width; the next drawing goes up as many rows as the old lines then take (where a
// terminal cuts instead of folding, it covers a few of the permanent lines).
// A paused terminal (Ctrl-S) costs drawings, not time, but for Finish(): permanent lines wait for
// the next drawing. A terminal that is gone ends the activity silently. The cursor is hidden from
// the first drawing to Finish(). Thread-compatible; nobody else writes to the terminal meanwhile.
#include <unistd.h>

#include <string>
#include <string_view>
#include <vector>

#include "deploy/live_view.h"

namespace ronda {

class Screen {
 public:
  explicit Screen(bool wanted, int output = STDOUT_FILENO);
  ~Screen() { Finish(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  bool active() const { return active_; }
  /// The room for a picture at present: one row and one column less than the terminal has.
  ViewSize size() const;
  /// `lines` as RenderRunStatus gives them.
  void Draw(std::vector<std::string> lines);
  /// Lines above the picture, to stay; made harmless.
  void Print(std::string_view text);
  /// Leaves the last picture standing, the cursor below it. The next Draw begins a new one.
  void Finish();

 private:
  void Paint();
  void Write(std::string_view bytes);

  int output_;
  bool active_;
  bool cursor_hidden_ = false;
  std::vector<std::string> wanted_;  // the lines of the picture
  std::vector<std::string> drawn_;   // what stands above the cursor
  std::string pending_;              // permanent lines not written yet
};

/// kPlain where NO_COLOR is set to anything but the empty string (https://no-color.org).
ViewStyle TerminalStyle();
/// Of local time at that moment.
int UtcOffset(double unix_s);

}  // namespace ronda
