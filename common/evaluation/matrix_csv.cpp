#include "common/evaluation/matrix_csv.h"

#include <fmt/format.h>

#include <optional>

#include "common/evaluation/csv_field.h"

namespace ronda {
namespace {

/// Header and rows out of one list of columns, so that they cannot differ.
class CsvTable {
 public:
  void Add(const char* column, const std::string& field) {
    if (first_row_) header_ += (header_.empty() ? "" : ",") + std::string(column);
    row_ += (row_begun_ ? "," : "") + CsvField(field);
    row_begun_ = true;
  }
  void AddEstimate(const char* mean, const char* ci95, const std::optional<Estimate>& estimate) {
    AddNumber(mean, estimate ? std::optional(estimate->mean) : std::nullopt);
    AddNumber(ci95, estimate ? estimate->ci95 : std::nullopt);
  }
  template <typename Number>
  void AddNumber(const char* column, const std::optional<Number>& value) {
    Add(column, value ? fmt::format("{}", *value) : "");
  }
  void EndRow() {
    rows_ += row_ + "\n";
    row_.clear();
    row_begun_ = first_row_ = false;
  }
  std::string Text() const { return header_ + "\n" + rows_; }

 private:
  std::string header_, row_, rows_;
  bool first_row_ = true;
  bool row_begun_ = false;
};

void AddRow(CsvTable& table, const EvaluationReport& report, const EvaluationReport* best) {
  const EvaluationOptions& options = report.options;
  const EvaluationResult& result = report.result;
  const Ratios ratios = RatiosOf(report, best);
  table.Add("map", report.map);
  table.AddNumber<int>("agents", options.agents);
  table.Add("conditions", Label(options.conditions));
  table.Add("contestant", report.contestant.name);
  table.Add("kind", KindName(report.contestant.kind));
  table.Add("protocol", std::string(ProtocolName(options.protocol)));
  table.AddNumber<int>("episodes", options.episodes);
  table.AddNumber<std::uint64_t>("seed", options.seed);
  table.AddNumber<double>("warmup_s", result.warmup_s);
  table.AddNumber<double>("window_s", result.window_s);
  table.AddNumber<std::int64_t>("decisions", result.decisions());
  table.AddEstimate("agi_s", "agi_ci95_s", MeanWithInterval(result.agi_s()));
  table.AddEstimate("wi_s", "wi_ci95_s", MeanWithInterval(result.wi_s()));
  table.AddEstimate("final_s", "final_ci95_s", MeanWithInterval(result.final_s()));
  const auto bound_s = [&](double LowerBounds::*value_s) {
    return report.bounds ? std::optional(*report.bounds.*value_s) : std::nullopt;
  };
  table.AddNumber("lower_bound_agi_s", bound_s(&LowerBounds::agi_s));
  table.AddNumber("lower_bound_wi_s", bound_s(&LowerBounds::wi_s));
  table.AddEstimate("agi_to_lower_bound", "agi_to_lower_bound_ci95", ratios.agi_to_bound);
  table.AddEstimate("wi_to_lower_bound", "wi_to_lower_bound_ci95", ratios.wi_to_bound);
  table.Add("best_classical", best == nullptr ? "" : best->contestant.name);
  table.AddEstimate("to_best_classical", "to_best_classical_ci95", ratios.to_best_classical);
  table.AddNumber("ratio_to_random", report.ratio_to_random);
  table.EndRow();
}

}  // namespace

std::string ResultsCsv(const Matrix& matrix) {
  CsvTable table;
  for (const Comparison& comparison : matrix) {
    const EvaluationReport* best = BestClassical(comparison);
    for (const EvaluationReport& report : comparison) AddRow(table, report, best);
  }
  return table.Text();
}

void WriteEpisodesCsv(const Matrix& matrix, OutputFile& file) {
  file.Write("map,agents,conditions,contestant,kind,episode,agi_s,wi_s,final_s,decisions\n");
  for (const Comparison& comparison : matrix) {
    for (const EvaluationReport& report : comparison) {
      const std::string cell =
          fmt::format("{},{},{},{},{}", CsvField(report.map), report.options.agents,
                      CsvField(Label(report.options.conditions)), CsvField(report.contestant.name),
                      KindName(report.contestant.kind));
      int number = 0;
      for (const EpisodeResult& episode : report.result.episodes) {
        file.Write(fmt::format("{},{},{},{},{},{}\n", cell, number++, episode.agi_s, episode.wi_s,
                               episode.final_s, episode.decisions));
      }
    }
  }
}

}  // namespace ronda
