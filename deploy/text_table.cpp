#include "deploy/text_table.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr int kGap = 2;

std::string Spaces(int count) { return std::string(static_cast<std::size_t>(count), ' '); }

/// Width of each column in the order of the columns; 0: left out.
std::vector<int> Widths(const std::vector<TableColumn>& columns,
                        const std::vector<TableRow>& rows) {
  std::vector<int> widths(columns.size(), 0);
  for (const TableRow& row : rows) {
    RONDA_CHECK(row.size() == columns.size(), "{} cells, {} columns", row.size(), columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const int needed = DisplayColumns(Harmless(row[i].text));
      widths[i] = std::max(widths[i], std::min(needed, columns[i].widest));
    }
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (widths[i] > 0) widths[i] = std::max(widths[i], DisplayColumns(columns[i].heading));
  }
  return widths;
}

/// Ends with the last cell that has something.
StyledLine RowLine(const std::vector<TableColumn>& columns, const std::vector<int>& widths,
                   const TableRow& row) {
  const auto last = std::find_if(row.rbegin(), row.rend(),
                                 [](const TableCell& cell) { return !cell.text.empty(); });
  const auto cells = static_cast<std::size_t>(row.rend() - last);
  StyledLine line;
  for (std::size_t i = 0; i < cells; ++i) {
    if (widths[i] == 0) continue;
    const std::string text = Cut(row[i].text, widths[i]);
    const std::string padding = Spaces(widths[i] - DisplayColumns(text));
    if (!line.empty()) line.Add(Spaces(kGap));
    if (columns[i].align == Align::kRight) line.Add(padding);
    line.Add(text, row[i].colour);
    if (columns[i].align == Align::kLeft && i + 1 < cells) line.Add(padding);
  }
  return line;
}

}  // namespace

std::vector<StyledLine> TableLines(const std::vector<TableColumn>& columns,
                                   const std::vector<TableRow>& rows) {
  const std::vector<int> widths = Widths(columns, rows);
  TableRow heading;
  for (const TableColumn& column : columns) heading.push_back({column.heading, Colour::kDim});
  std::vector<StyledLine> lines{RowLine(columns, widths, heading)};
  for (const TableRow& row : rows) lines.push_back(RowLine(columns, widths, row));
  return lines;
}

}  // namespace ronda
