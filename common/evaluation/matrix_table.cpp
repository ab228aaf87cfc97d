#include "common/evaluation/matrix_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

std::vector<double> ValuesOf(const EvaluationReport& report, Metric metric) {
  if (metric == Metric::kAgi) return report.result.agi_s();
  return metric == Metric::kWi ? report.result.wi_s() : report.result.final_s();
}

std::optional<double> BoundOf(const EvaluationReport& report, Metric metric) {
  if (metric == Metric::kFinal) return std::nullopt;
  return metric == Metric::kAgi ? report.bounds.agi_s : report.bounds.wi_s;
}

std::string TitleOf(Metric metric, RatioTo ratio_to) {
  const std::string name = metric == Metric::kAgi  ? "AGI"
                           : metric == Metric::kWi ? "WI"
                                                   : "final idleness";
  if (ratio_to == RatioTo::kBestClassical) return name + " to that of the best classical strategy";
  const bool to_bound = ratio_to == RatioTo::kBound && metric != Metric::kFinal;
  return name + (to_bound ? " to the lower bound" : " (s)");
}

Estimate CellOf(const EvaluationReport& report, const EvaluationReport* best, Metric metric,
                RatioTo ratio_to) {
  const std::vector<double> values = ValuesOf(report, metric);
  if (ratio_to == RatioTo::kBestClassical) return PairedRatio(values, ValuesOf(*best, metric));
  const auto bound = BoundOf(report, metric);
  const Estimate estimate = MeanWithInterval(values);
  return ratio_to == RatioTo::kBound && bound ? Over(estimate, *bound) : estimate;
}

/// The lower bound in the table's unit.
std::optional<double> BoundCell(const EvaluationReport& first, const EvaluationReport* best,
                                Metric metric, RatioTo ratio_to) {
  const auto bound = BoundOf(first, metric);
  if (!bound || ratio_to == RatioTo::kBound) return std::nullopt;
  if (ratio_to == RatioTo::kNothing) return bound;
  return *bound / MeanWithInterval(ValuesOf(*best, metric)).mean;
}

void AddColumn(MatrixTable& table, const Comparison& comparison, Metric metric, RatioTo ratio_to) {
  const EvaluationReport* best = BestClassicalOf(comparison);
  RONDA_CHECK(best != nullptr || ratio_to != RatioTo::kBestClassical, "no classical strategy");
  table.agents.push_back(comparison.front().options.agents);
  table.rows.resize(comparison.size());
  for (std::size_t i = 0; i < comparison.size(); ++i) {
    table.rows[i].contestant = comparison[i].contestant.name;
    table.rows[i].values.push_back(CellOf(comparison[i], best, metric, ratio_to));
  }
  const auto least = std::ranges::min_element(
      table.rows, {}, [](const MatrixTable::Row& row) { return row.values.back().mean; });
  table.best.push_back(static_cast<std::size_t>(least - table.rows.begin()));
  const auto bound = BoundCell(comparison.front(), best, metric, ratio_to);
  if (bound) table.lower_bound.push_back(*bound);
}

}  // namespace

std::vector<Metric> MetricsOf(Protocol protocol) {
  if (protocol == Protocol::kThesis) return {Metric::kFinal, Metric::kAgi, Metric::kWi};
  return {Metric::kAgi, Metric::kWi};
}

MatrixTable TableOf(std::span<const Comparison> panel, Metric metric, RatioTo ratio_to) {
  MatrixTable table;
  table.title = TitleOf(metric, ratio_to);
  for (const Comparison& comparison : panel) AddColumn(table, comparison, metric, ratio_to);
  return table;
}

int DecimalsOf(const MatrixTable& table) {
  double least = table.rows.front().values.front().mean;
  for (const MatrixTable::Row& row : table.rows) {
    for (const Estimate& value : row.values) least = std::min(least, value.mean);
  }
  return least < 1.0 ? 4 : least < 100.0 ? 2 : 1;
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
  return text + fmt::format("; robots at {:g} m/s; {} episode{} of seed {}", options.speed_mps,
                            options.episodes, options.episodes == 1 ? "" : "s", options.seed);
}

}  // namespace ronda
