#include "common/evaluation/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr std::size_t kColumns = 8;
using Row = std::array<std::string, kColumns>;

/// Characters as a terminal counts them (bytes that do not continue a UTF-8 sequence).
std::size_t DisplayWidth(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// Names on the left, figures on the right, two spaces between.
std::string FormatTable(const std::vector<Row>& rows) {
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < kColumns; ++c) {
      widths[c] = std::max(widths[c], DisplayWidth(row[c]));
    }
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < kColumns; ++c) {
      const std::string padding(widths[c] - DisplayWidth(row[c]), ' ');
      line += (c > 0 ? "  " : "") + (c < 2 ? row[c] + padding : padding + row[c]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::vector<double> Headline(const EvaluationReport& report) {
  return report.options.protocol == Protocol::kThesis ? report.result.final_s()
                                                      : report.result.agi_s();
}

std::string FormatRatio(const Estimate& ratio) {
  if (!ratio.ci95) return fmt::format("{:.3f}", ratio.mean);
  return fmt::format("{:.3f} ± {:.3f}", ratio.mean, *ratio.ci95);
}

std::optional<Estimate> OverBound(const std::vector<double>& values_s, double bound_s) {
  if (bound_s == 0.0) return std::nullopt;
  return Over(MeanWithInterval(values_s), bound_s);
}

Row FormatRow(const EvaluationReport& report, const EvaluationReport* best) {
  const Ratios ratios = RatiosOf(report, best);
  const bool policy = report.contestant.kind == ContestantKind::kPolicy;
  return {report.contestant.name,
          policy ? "as trained" : StrategyKnowledge(report.contestant.name),
          FormatEstimate(MeanWithInterval(report.result.agi_s())),
          FormatEstimate(MeanWithInterval(report.result.wi_s())),
          FormatEstimate(MeanWithInterval(report.result.final_s())),
          ratios.to_best_classical ? FormatRatio(*ratios.to_best_classical) : "",
          ratios.agi_to_bound ? FormatRatio(*ratios.agi_to_bound) : "",
          report.ratio_to_random ? fmt::format("{:.2f}", *report.ratio_to_random) : ""};
}

}  // namespace

const EvaluationReport* BestClassical(std::span<const EvaluationReport> reports) {
  const EvaluationReport* best = nullptr;
  double best_s = 0.0;
  for (const EvaluationReport& report : reports) {
    if (report.contestant.kind != ContestantKind::kStrategy) continue;
    const double mean_s = MeanWithInterval(Headline(report)).mean;
    if (best == nullptr || mean_s < best_s) {
      best = &report;
      best_s = mean_s;
    }
  }
  return best;
}

Ratios RatiosOf(const EvaluationReport& report, const EvaluationReport* best) {
  Ratios ratios;
  if (best != nullptr) ratios.to_best_classical = PairedRatio(Headline(report), Headline(*best));
  if (!report.bounds) return ratios;
  ratios.agi_to_bound = OverBound(report.result.agi_s(), report.bounds->agi_s);
  ratios.wi_to_bound = OverBound(report.result.wi_s(), report.bounds->wi_s);
  return ratios;
}

std::string FormatComparison(std::span<const EvaluationReport> reports) {
  RONDA_CHECK(!reports.empty(), "a comparison of nothing");
  const EvaluationReport& first = reports.front();
  const EvaluationReport* best = BestClassical(reports);
  const bool thesis = first.options.protocol == Protocol::kThesis;
  std::vector<Row> rows;
  rows.push_back({"", "knows", "AGI (s)", "WI (s)", "final (s)",
                  best == nullptr ? "" : "to best classical", first.bounds ? "AGI to bound" : "",
                  thesis ? "random to it" : ""});
  for (const EvaluationReport& report : reports) rows.push_back(FormatRow(report, best));
  if (first.bounds) {
    rows.push_back({"lower bound", "", FormatSeconds(first.bounds->agi_s),
                    FormatSeconds(first.bounds->wi_s), "", "", "", ""});
  }
  std::string text = FormatSetting(first) + "\n" + FormatTable(rows) + "\n";
  if (best != nullptr) {
    text += fmt::format("Best classical strategy by {}: {}; ratios to it are paired by episode.\n",
                        thesis ? "final idleness" : "AGI", best->contestant.name);
  }
  return text + FormatBoundsNote(first);
}

}  // namespace ronda
