#pragma once
// A matrix on a terminal: for each panel its name and protocol, and for each metric a table of
// means, rows contestants and columns team sizes, the best of each column marked with *.
//
// Tables wider than `columns` go on below with the next team sizes. Pure.
#include <string>

#include "common/evaluation/matrix_table.h"
#include "deploy/terminal_text.h"

namespace ronda {

struct MatrixLook {
  int columns = 100;
  ViewStyle style = ViewStyle::kPlain;
};

std::string MatrixAsText(const Matrix& matrix, const MatrixLook& look);

}  // namespace ronda
