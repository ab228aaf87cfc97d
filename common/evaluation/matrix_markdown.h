#pragma once
// A matrix as markdown for papers and reports.
//
// For each panel a heading, and for each metric a caption (protocol, window, episodes, seed) and a
// pipe table: mean ± half width of the 95 % interval, the best of each column in bold. Pure.
#include <string>

#include "common/evaluation/matrix_table.h"

namespace ronda {

std::string MatrixAsMarkdown(const Matrix& matrix);

}  // namespace ronda
