#include "common/evaluation/matrix_json.h"

#include <nlohmann/json.hpp>

#include "common/evaluation/report_json.h"

namespace ronda {
namespace {

nlohmann::ordered_json OrNull(const std::optional<Estimate>& estimate) {
  return estimate ? EstimateAsJson(*estimate) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::string MatrixAsJson(const Matrix& matrix) {
  using Json = nlohmann::ordered_json;
  auto list = Json::array();
  for (const Comparison& comparison : matrix) {
    const EvaluationReport* best = BestClassical(comparison);
    for (const EvaluationReport& report : comparison) {
      const Ratios ratios = RatiosOf(report, best);
      Json json = ReportAsJsonValue(report);
      json["best_classical"] = best == nullptr ? Json(nullptr) : Json(best->contestant.name);
      json["to_best_classical"] = OrNull(ratios.to_best_classical);
      json["agi_to_lower_bound"] = OrNull(ratios.agi_to_bound);
      json["wi_to_lower_bound"] = OrNull(ratios.wi_to_bound);
      list.push_back(std::move(json));
    }
  }
  return list.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ronda
