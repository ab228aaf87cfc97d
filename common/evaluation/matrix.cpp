#include "common/evaluation/matrix.h"

#include "common/base/check.h"

namespace ronda {
namespace {

bool InOnePanel(const Comparison& a, const Comparison& b) {
  return a.front().map == b.front().map &&
         a.front().options.conditions == b.front().options.conditions;
}

}  // namespace

std::vector<std::span<const Comparison>> Panels(const Matrix& matrix) {
  std::vector<std::span<const Comparison>> panels;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    RONDA_CHECK(!matrix[i].empty(), "a comparison of nothing");
    if (i + 1 < matrix.size() && InOnePanel(matrix[i], matrix[i + 1])) continue;
    panels.emplace_back(&matrix[begin], i + 1 - begin);
    begin = i + 1;
  }
  return panels;
}

std::string PanelName(const EvaluationReport& report) {
  const std::string conditions = Label(report.options.conditions);
  return conditions.empty() ? report.map : report.map + ", " + conditions;
}

}  // namespace ronda
