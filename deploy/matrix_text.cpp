#include "deploy/matrix_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "deploy/text_table.h"

namespace ronda {
namespace {

constexpr int kWidestName = 30;
constexpr int kGap = 2;
constexpr const char* kBound = "lower bound";

/// The cells of a table, each as wide as the others: figure and mark.
struct Cells {
  std::vector<std::string> headings;  // (columns)
  std::vector<TableRow> rows;         // (rows) name and (columns)
};

Cells CellsOf(const MatrixTable& table) {
  const int decimals = DecimalsOf(table);
  Cells cells;
  for (const int agents : table.agents) cells.headings.push_back(fmt::format("N={} ", agents));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    TableRow& row = cells.rows.emplace_back(TableRow{{.text = table.rows[i].contestant}});
    for (std::size_t column = 0; column < table.agents.size(); ++column) {
      const bool best = table.best[column] == i;
      row.push_back(
          {fmt::format("{:.{}f}{}", table.rows[i].values[column].mean, decimals, best ? '*' : ' '),
           best ? Colour::kBold : Colour::kNone});
    }
  }
  if (table.lower_bound.empty()) return cells;
  TableRow& row = cells.rows.emplace_back(TableRow{{kBound, Colour::kDim}});
  for (const double bound : table.lower_bound) {
    row.push_back({fmt::format("{:.{}f} ", bound, decimals), Colour::kDim});
  }
  return cells;
}

/// The end of the team sizes from `begin` on that fit beside the names; at least one does.
std::size_t EndThatFits(const Cells& cells, std::size_t begin, int columns) {
  int left = columns;
  int widest = 0;
  for (const TableRow& row : cells.rows) {
    widest = std::max(widest, std::min(DisplayColumns(row.front().text), kWidestName));
  }
  left -= widest;
  for (std::size_t i = begin; i < cells.headings.size(); ++i) {
    widest = DisplayColumns(cells.headings[i]);
    for (const TableRow& row : cells.rows) {
      widest = std::max(widest, DisplayColumns(row[i + 1].text));
    }
    left -= kGap + widest;
    if (left < 0) return std::max(begin + 1, i);
  }
  return cells.headings.size();
}

std::string Draw(const StyledLine& line, const MatrixLook& look) {
  std::string text = line.Draw(std::max(look.columns, line.columns()), look.style);
  return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

/// The team sizes `begin` … `end` − 1 of a table.
std::string DrawColumns(const Cells& cells, std::size_t begin, std::size_t end,
                        const MatrixLook& look) {
  std::vector<TableColumn> columns{{.heading = "", .widest = kWidestName}};
  for (std::size_t i = begin; i < end; ++i) {
    columns.push_back({.heading = cells.headings[i], .align = Align::kRight});
  }
  std::vector<TableRow> rows;
  for (const TableRow& row : cells.rows) {
    TableRow& shown = rows.emplace_back(TableRow{row.front()});
    shown.insert(shown.end(), row.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
                 row.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  }
  std::string text;
  for (const StyledLine& line : TableLines(columns, rows)) text += Draw(line, look);
  return text;
}

std::string DrawTable(const MatrixTable& table, const MatrixLook& look) {
  const Cells cells = CellsOf(table);
  std::string text = "\n" + Draw(StyledLine(table.title, Colour::kBold), look);
  for (std::size_t begin = 0, end = 0; begin < cells.headings.size(); begin = end) {
    end = EndThatFits(cells, begin, look.columns);
    text += (begin > 0 ? "\n" : "") + DrawColumns(cells, begin, end, look);
  }
  return text;
}

}  // namespace

std::string MatrixAsText(const Matrix& matrix, const MatrixLook& look) {
  std::string text;
  for (const std::span<const Comparison> panel : Panels(matrix)) {
    text += Draw(StyledLine(PanelName(panel.front().front()), Colour::kBold), look);
    text += Draw(StyledLine(DescribeProtocol(panel), Colour::kDim), look);
    for (const Metric metric : MetricsOf(panel)) {
      text += DrawTable(TableOf(panel, metric), look);
    }
    text += "\n";
  }
  return text +
         "Means over episodes, N robots; * is the best. Intervals: --format markdown, csv or "
         "json.\n";
}

}  // namespace ronda
