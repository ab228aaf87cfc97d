#pragma once
// A matrix as CSV for plots and statistics elsewhere: a row a cell, and a row an episode.
//
// RFC 4180 with a header; columns: docs/evaluation.md. Numbers read back to the same doubles; what
// does not exist (an interval of one episode) is empty.
#include <string>

#include "common/evaluation/matrix.h"
#include "common/evaluation/output_file.h"

namespace ronda {

std::string ResultsCsv(const Matrix& matrix);

/// Errors as OutputFile.
void WriteEpisodesCsv(const Matrix& matrix, OutputFile& file);

}  // namespace ronda
