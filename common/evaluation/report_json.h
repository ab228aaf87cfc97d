#pragma once
// A report as a JSON value, for the .cpp files that put several into one text; the only header here
// that sees the JSON library.
#include <nlohmann/json_fwd.hpp>

#include "common/evaluation/report.h"

namespace ronda {

nlohmann::ordered_json EstimateAsJson(const Estimate& estimate);

nlohmann::ordered_json ReportAsJsonValue(const EvaluationReport& report);

}  // namespace ronda
