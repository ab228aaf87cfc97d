#pragma once
// Several contestants on one setting, side by side: a table for people, a list for programs.
//
// All reports share map, options and bounds, hence the same starts episode by episode, so ratios
// are paired. They are of the headline figure: AGI under the steady protocol, final idleness under
// the thesis's. Pure functions; at least one report, else a bug.
#include <optional>
#include <span>
#include <string>

#include "common/evaluation/report.h"

namespace ronda {

/// The classical strategy with the least headline figure; nullopt when only policies are compared.
std::optional<std::size_t> BestClassical(std::span<const EvaluationReport> reports);

std::string FormatComparison(std::span<const EvaluationReport> reports);

/// A JSON list of ReportAsJson's objects, in order.
std::string ComparisonAsJson(std::span<const EvaluationReport> reports);

}  // namespace ronda
