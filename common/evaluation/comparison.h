#pragma once
// Several contestants on one setting, side by side: ratios, and a table for people.
//
// All reports share map, options and bounds, hence the same starts episode by episode, so ratios
// are paired. They are of the headline figure: AGI under the steady protocol, final idleness under
// the thesis's. Pure functions; at least one report, else a bug.
#include <optional>
#include <span>
#include <string>

#include "common/evaluation/report.h"

namespace ronda {

/// The classical strategy with the least headline figure; null when only policies are compared.
const EvaluationReport* BestClassical(std::span<const EvaluationReport> reports);

/// A report's figures over what they are judged by.
struct Ratios {
  std::optional<Estimate> to_best_classical;  // of the headline figure; none without such
  std::optional<Estimate> agi_to_bound;       // none where no bound is known, or it is 0
  std::optional<Estimate> wi_to_bound;
};

/// `best`: BestClassical's report, or null.
Ratios RatiosOf(const EvaluationReport& report, const EvaluationReport* best);

std::string FormatComparison(std::span<const EvaluationReport> reports);

}  // namespace ronda
