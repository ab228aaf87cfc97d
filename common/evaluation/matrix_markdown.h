#pragma once
// A matrix as markdown for papers and reports.
//
// For each panel a heading, and for each metric a caption (protocol, window, episodes, seed) and a
// pipe table: mean ± half width of the 95 % interval, the best of each column in bold. Where there
// is a classical strategy, a last table gives the headline figure's ratios to the best one. Pure.
#include <string>

#include "common/evaluation/matrix_table.h"

namespace ronda {

/// Metrics as `ratio_to` says.
std::string MatrixAsMarkdown(const Matrix& matrix, RatioTo ratio_to);

}  // namespace ronda
