#pragma once
// A run on one screen: the lines that show a RunStatus, for a terminal of a given size.
//
// From above: state and progress, rates, learning curve, problems, processes, channels, last
// events. No line is wider than `columns`, and there are at most `rows` of them. Where the screen
// is too low these go first: all events but the last, actors beyond the first three (a line sums
// them up, and those in trouble stand first), the gaps, the channels, the last event, the other
// actors; then the lower end of what is left.
// The curve: `columns` blocks at most, see sparkline.h; green is below the best classical strategy.
// What the status says cannot drive the terminal: its texts are made harmless.
// Pure: "now" is status.written_unix_s. O(size of the status).
#include <string>
#include <vector>

#include "deploy/run_status.h"
#include "deploy/terminal_text.h"

namespace ronda {

struct ViewSize {
  int columns = 80;
  int rows = 24;
};

/// `utc_offset_s`: of the clock that events are shown by.
std::vector<std::string> RenderRunStatus(const RunStatus& status, const ViewSize& size,
                                         ViewStyle style, int utc_offset_s = 0);

}  // namespace ronda
