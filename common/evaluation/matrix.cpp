#include "common/evaluation/matrix.h"

#include "common/base/check.h"

namespace ronda {

std::vector<std::span<const Comparison>> Panels(const Matrix& matrix) {
  std::vector<std::span<const Comparison>> panels;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    RONDA_CHECK(!matrix[i].empty(), "a comparison of nothing");
    const bool last =
        i + 1 == matrix.size() || PanelName(matrix[i + 1].front()) != PanelName(matrix[i].front());
    if (!last) continue;
    panels.emplace_back(&matrix[begin], i + 1 - begin);
    begin = i + 1;
  }
  return panels;
}

std::string PanelName(const EvaluationReport& report) {
  const std::string condition = ConditionLabel(report.options);
  return condition.empty() ? report.map : report.map + ", " + condition;
}

const EvaluationReport* BestClassicalOf(const Comparison& comparison) {
  const auto best = BestClassical(comparison);
  return best ? &comparison[*best] : nullptr;
}

}  // namespace ronda
