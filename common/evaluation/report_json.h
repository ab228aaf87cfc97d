#pragma once
// A report as a JSON value, for the .cpp files that put several into one text; the only header here
// that sees the JSON library.
#include <nlohmann/json_fwd.hpp>

#include "common/evaluation/report.h"

namespace ronda {

/// The first keys of a report: what was judged on what, without any result. Every option that
/// changes results is among them: what is kept is found by them (deploy/cell_journal.h).
nlohmann::ordered_json SettingAsJson(const EvaluationReport& report);

nlohmann::ordered_json EstimateAsJson(const Estimate& estimate);

nlohmann::ordered_json ReportAsJsonValue(const EvaluationReport& report);

}  // namespace ronda
