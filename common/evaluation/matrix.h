#pragma once
// Contestants on many settings: maps × conditions × team sizes.
//
// The team size varies fastest, then the condition, then the map. A panel is what one table or one
// picture shows: the settings of one map under one condition, which differ in team size only. Every
// setting has the same contestants in the same order. Pure functions.
#include <span>
#include <string>
#include <vector>

#include "common/evaluation/comparison.h"

namespace ronda {

using Comparison = std::vector<EvaluationReport>;  // (contestants) of one setting
using Matrix = std::vector<Comparison>;            // (settings)

/// In order; together they are the matrix.
std::vector<std::span<const Comparison>> Panels(const Matrix& matrix);

/// "cumberland, noise 0.1": what the reports of a panel share.
std::string PanelName(const EvaluationReport& report);

}  // namespace ronda
