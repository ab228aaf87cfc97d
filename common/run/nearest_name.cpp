#include "common/run/nearest_name.h"

#include <algorithm>

namespace ronda {

int EditDistance(std::string_view a, std::string_view b) {
  // Row i holds the distances of a's first i letters to all beginnings of b.
  std::vector<int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::optional<std::string> NearestName(std::string_view name,
                                       const std::vector<std::string>& known) {
  const auto same_but_for_sections = [&](const std::string& key) {
    return name.ends_with("." + key) || key.ends_with("." + std::string(name));
  };
  const auto moved = std::find_if(known.begin(), known.end(), same_but_for_sections);
  if (moved != known.end()) return *moved;
  const auto nearest = std::min_element(
      known.begin(), known.end(), [&](const std::string& left, const std::string& right) {
        return EditDistance(name, left) < EditDistance(name, right);
      });
  if (nearest == known.end()) return std::nullopt;
  return *nearest;
}

}  // namespace ronda
