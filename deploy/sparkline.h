#pragma once
// A curve as one row of blocks ▁▂▃▄▅▆▇█ in which the reference value is the middle.
//
// With a reference the scale is linear with the bound at the bottom and the reference between ▄ and
// ▅, so that ▁▂▃▄ are below it and ▅▆▇█ are not; twice as far from the bound as the reference, and
// all above, is █. Without one, or where it is not above the bottom, the scale ends at the largest
// value. Without a bound it begins at the least value. A curve with nothing to compare it to is ▄.
// Lower is better. Pure; O(values).
#include <optional>
#include <string_view>
#include <vector>

namespace ronda {

struct CurveMarks {
  std::optional<double> bound;
  std::optional<double> reference;
};

enum class Side { kUnknown, kBelow, kNotBelow };  // of the reference

struct CurveBlock {
  int level = 0;  // 0 … 7
  Side side = Side::kUnknown;
};

/// "▁" … "█".
std::string_view BlockText(const CurveBlock& block);

/// min(columns, values) blocks, oldest first; where values are more than columns each block is the
/// mean of its share of them. What is not finite, value or mark, is left out.
std::vector<CurveBlock> Sparkline(std::vector<double> values, const CurveMarks& marks, int columns);

}  // namespace ronda
