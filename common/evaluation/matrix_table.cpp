#include "common/evaluation/matrix_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

std::string TitleOf(Metric metric, Protocol protocol) {
  if (metric == Metric::kAgi) return "AGI (s)";
  if (metric == Metric::kWi) return "WI (s)";
  if (metric == Metric::kFinal) return "final idleness (s)";
  return fmt::format("{} to that of the best classical strategy",
                     protocol == Protocol::kThesis ? "final idleness" : "AGI");
}

Estimate CellOf(const EvaluationReport& report, const EvaluationReport* best, Metric metric) {
  if (metric == Metric::kAgi) return MeanWithInterval(report.result.agi_s());
  if (metric == Metric::kWi) return MeanWithInterval(report.result.wi_s());
  if (metric == Metric::kFinal) return MeanWithInterval(report.result.final_s());
  const auto ratio = RatiosOf(report, best).to_best_classical;
  RONDA_CHECK(ratio, "ratios to classical strategies need one");
  return *ratio;
}

void AddColumn(MatrixTable& table, const Comparison& comparison, Metric metric) {
  const EvaluationReport* best = BestClassical(comparison);
  const EvaluationReport& first = comparison.front();
  table.agents.push_back(first.options.agents);
  table.rows.resize(comparison.size());
  for (std::size_t i = 0; i < comparison.size(); ++i) {
    table.rows[i].contestant = comparison[i].contestant.name;
    table.rows[i].values.push_back(CellOf(comparison[i], best, metric));
  }
  const auto least = std::ranges::min_element(
      table.rows, {}, [](const MatrixTable::Row& row) { return row.values.back().mean; });
  table.best.push_back(static_cast<std::size_t>(least - table.rows.begin()));
  if (!first.bounds) return;
  if (metric == Metric::kAgi) table.lower_bound.push_back(first.bounds->agi_s);
  if (metric == Metric::kWi) table.lower_bound.push_back(first.bounds->wi_s);
}

}  // namespace

std::vector<Metric> MetricsOf(std::span<const Comparison> panel) {
  std::vector<Metric> metrics{Metric::kAgi, Metric::kWi};
  const Comparison& first = panel.front();
  if (first.front().options.protocol == Protocol::kThesis) {
    metrics.insert(metrics.begin(), Metric::kFinal);
  }
  if (BestClassical(first) != nullptr) metrics.push_back(Metric::kRatio);
  return metrics;
}

MatrixTable TableOf(std::span<const Comparison> panel, Metric metric) {
  MatrixTable table;
  table.title = TitleOf(metric, panel.front().front().options.protocol);
  for (const Comparison& comparison : panel) AddColumn(table, comparison, metric);
  return table;
}

int DecimalsOf(const MatrixTable& table) {
  double least = table.rows.front().values.front().mean;
  for (const MatrixTable::Row& row : table.rows) {
    for (const Estimate& value : row.values) least = std::min(least, value.mean);
  }
  return least < 10.0 ? 3 : least < 100.0 ? 2 : 1;
}

std::string DescribeProtocol(std::span<const Comparison> panel) {
  const EvaluationReport& first = panel.front().front();
  const EvaluationOptions& options = first.options;
  std::string text = fmt::format("{} protocol: ", ProtocolName(options.protocol));
  if (options.protocol == Protocol::kThesis) {
    text += fmt::format("from zero idleness to {:g} s", options.horizon_s);
  } else {
    text += fmt::format("warm-up {:g}, window {:g} T_ref of {:.5g} s / N", kWarmupTref, kWindowTref,
                        first.result.t_ref_s * options.agents);
  }
  return text + fmt::format("; robots at {:g} m/s; {} episode{} of seed {}",
                            fmt::join(options.conditions.speeds_mps, "/"), options.episodes,
                            options.episodes == 1 ? "" : "s", options.seed);
}

}  // namespace ronda
