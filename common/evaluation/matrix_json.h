#pragma once
// A matrix for programs: one JSON list, an object for each contestant on each setting, in order.
//
// Keys: those of a report, and ratios (docs/evaluation.md). Numbers read back to the
// same doubles. Pure.
#include <string>

#include "common/evaluation/matrix.h"

namespace ronda {

/// Indented, without a line end.
std::string MatrixAsJson(const Matrix& matrix);

}  // namespace ronda
