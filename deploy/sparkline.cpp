#include "deploy/sparkline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace ronda {
namespace {

constexpr int kLevels = 8;

/// Means of consecutive shares that are as equal as can be.
std::vector<double> Shares(const std::vector<double>& values, std::size_t count) {
  std::vector<double> means;
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * values.size() / count);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>((i + 1) * values.size() / count);
    means.push_back(std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin));
  }
  return means;
}

std::optional<double> Finite(const std::optional<double>& mark) {
  return mark && std::isfinite(*mark) ? mark : std::nullopt;
}

}  // namespace

std::string_view BlockText(const CurveBlock& block) {
  constexpr std::array<std::string_view, kLevels> kBlocks{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  return kBlocks.at(static_cast<std::size_t>(block.level));
}

std::vector<CurveBlock> Sparkline(std::vector<double> values, const CurveMarks& marks,
                                  int columns) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty() || columns <= 0) return {};
  values = Shares(values, std::min(values.size(), static_cast<std::size_t>(columns)));

  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const auto reference = Finite(marks.reference);
  const double bottom = Finite(marks.bound).value_or(*least);
  const bool centred = reference && *reference > bottom;
  const double top = centred ? bottom + 2.0 * (*reference - bottom) : *largest;

  std::vector<CurveBlock> blocks;
  for (const double value : values) {
    CurveBlock block;
    const double height = (value - bottom) / (top - bottom) * kLevels;
    block.level = height > 0.0 ? static_cast<int>(std::min(height, kLevels - 1.0)) : 0;
    if (!(top > bottom)) block.level = 3;
    if (reference) block.side = value < *reference ? Side::kBelow : Side::kNotBelow;
    // Rounding must not put a value on the other side of the middle.
    if (centred && block.side == Side::kBelow) block.level = std::min(block.level, 3);
    if (centred && block.side == Side::kNotBelow) block.level = std::max(block.level, 4);
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace ronda
