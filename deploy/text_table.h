#pragma once
// Rows of cells, padded so that columns stand below each other on a terminal.
//
// The first line is the heading. Each column is as wide as its widest cell, at most `widest`
// (longer cells end in "…"), two spaces apart; a column in which no row has anything is left out.
// Pure.
#include <string>
#include <vector>

#include "deploy/terminal_text.h"

namespace ronda {

enum class Align { kLeft, kRight };

struct TableColumn {
  std::string heading;
  Align align = Align::kLeft;
  int widest = 1000;  // in columns of the terminal; 0: left out
};

struct TableCell {
  std::string text;
  Colour colour = Colour::kNone;
};

using TableRow = std::vector<TableCell>;  // a cell for each column

/// 1 + rows lines.
std::vector<StyledLine> TableLines(const std::vector<TableColumn>& columns,
                                   const std::vector<TableRow>& rows);

}  // namespace ronda
