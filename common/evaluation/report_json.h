#pragma once
// A report and its parts as JSON values, for the .cpp files that make one text of several; the only
// header here that sees the JSON library.
#include <nlohmann/json_fwd.hpp>

#include "common/evaluation/report.h"

namespace ronda {

/// Map, number of robots, speeds and all other conditions.
nlohmann::ordered_json TeamAsJsonValue(const std::string& map, const EvaluationOptions& options);

nlohmann::ordered_json EstimateAsJson(const Estimate& estimate);

nlohmann::ordered_json ReportAsJsonValue(const EvaluationReport& report);

}  // namespace ronda
