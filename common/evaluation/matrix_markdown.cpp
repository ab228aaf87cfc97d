#include "common/evaluation/matrix_markdown.h"

#include <fmt/format.h>

namespace ronda {
namespace {

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string FormatCell(const Estimate& value, int decimals, bool best) {
  std::string text = fmt::format("{:.{}f}", value.mean, decimals);
  if (value.ci95) text += fmt::format(" ± {:.{}f}", *value.ci95, decimals);
  return best ? "**" + text + "**" : text;
}

std::string FormatTable(const MatrixTable& table) {
  const int decimals = DecimalsOf(table);
  std::string text = "| |";
  for (const int agents : table.agents) text += fmt::format(" N = {} |", agents);
  text += "\n|---|";
  for (std::size_t column = 0; column < table.agents.size(); ++column) text += "--:|";
  text += "\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    text += fmt::format("| {} |", Escaped(table.rows[row].contestant));
    for (std::size_t column = 0; column < table.agents.size(); ++column) {
      const bool best = table.best[column] == row;
      text += fmt::format(" {} |", FormatCell(table.rows[row].values[column], decimals, best));
    }
    text += "\n";
  }
  if (table.lower_bound.empty()) return text;
  text += "| lower bound |";
  for (const double bound : table.lower_bound) text += fmt::format(" {:.{}f} |", bound, decimals);
  return text + "\n";
}

std::string FormatSection(std::span<const Comparison> panel, Metric metric) {
  const MatrixTable table = TableOf(panel, metric);
  const EvaluationReport& first = panel.front().front();
  return fmt::format("{}: {}. {} by number N of robots; {}; best in bold.\n\n{}\n",
                     Escaped(PanelName(first)), table.title,
                     first.options.episodes > 1 ? "Mean ± 95 % interval" : "Values",
                     DescribeProtocol(panel), FormatTable(table));
}

}  // namespace

std::string MatrixAsMarkdown(const Matrix& matrix) {
  std::string text;
  for (const std::span<const Comparison> panel : Panels(matrix)) {
    const EvaluationReport& first = panel.front().front();
    text += fmt::format("{}## {}\n\n", text.empty() ? "" : "\n", Escaped(PanelName(first)));
    for (const Metric metric : MetricsOf(panel)) text += FormatSection(panel, metric);
  }
  return text;
}

}  // namespace ronda
