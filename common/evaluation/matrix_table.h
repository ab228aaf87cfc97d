#pragma once
// One metric of one panel as a table of estimates: rows are contestants, columns team sizes.
//
// What every rendering shares (matrix_markdown.h, the terminal's). Pure.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/evaluation/matrix.h"

namespace ronda {

enum class Metric {
  kAgi,
  kWi,
  kFinal,
  kRatio,  // of the headline figure to the best classical strategy's, paired by episode
};

struct MatrixTable {
  std::string title;        // "AGI (s)"
  std::vector<int> agents;  // (columns)
  struct Row {
    std::string contestant;
    std::vector<Estimate> values;  // (columns)
  };
  std::vector<Row> rows;
  std::vector<std::size_t> best;    // (columns) the row with the least mean
  std::vector<double> lower_bound;  // (columns), or empty where there is none
};

/// What a panel is shown by: the headline figure first, ratios last and only where a classical
/// strategy takes part.
std::vector<Metric> MetricsOf(std::span<const Comparison> panel);

/// kRatio needs a classical strategy among the contestants, else a bug.
MatrixTable TableOf(std::span<const Comparison> panel, Metric metric);

/// Decimals under which a table's means are told apart: 3 where the least is below 10, 2 below
/// 100, else 1.
int DecimalsOf(const MatrixTable& table);

/// "steady protocol: warm-up 20, window 60 T_ref of 373.31 s / N; robots at 1 m/s; 20 episodes of
/// seed 1": what the settings of a panel share.
std::string DescribeProtocol(std::span<const Comparison> panel);

}  // namespace ronda
