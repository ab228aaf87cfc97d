#pragma once
// Plays a planned comparison on all cores: cells as listed, their episodes over one queue.
//
// Cells that the journal has are not played again; each other one is appended as soon as it is
// done. Results depend neither on the number of threads nor on what was played before. Throws what
// strategies and the journal throw.
#include <optional>
#include <stop_token>

#include "common/evaluation/matrix.h"
#include "deploy/cell_journal.h"
#include "deploy/matrix_plan.h"

namespace ronda {

struct MatrixRun {
  std::optional<Matrix> matrix;  // none when stopped
  std::size_t cells_done = 0;
};

/// `journal` may be null. Progress goes to stderr.
MatrixRun RunMatrix(const MatrixPlan& plan, CellJournal* journal, const std::stop_token& stop);

}  // namespace ronda
