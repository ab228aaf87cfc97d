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

struct SampleColumns {
  const char* mean;
  const char* ci95;
  const char* sd;
};

void AddSample(CsvTable& table, const SampleColumns& columns, const std::vector<double>& values) {
  const Estimate estimate = MeanWithInterval(values);
  table.AddNumber<double>(columns.mean, estimate.mean);
  table.AddNumber(columns.ci95, estimate.ci95);
  table.AddNumber(columns.sd, StandardDeviation(values));
}

void AddRow(CsvTable& table, const EvaluationReport& report, const EvaluationReport* best) {
  const EvaluationOptions& options = report.options;
  const EvaluationResult& result = report.result;
  const Ratios ratios = RatiosOf(report, best);
  const auto to_best = ratios.to_best_classical;
  table.Add("map", report.map);
  table.AddNumber<int>("agents", options.agents);
  table.Add("condition", ConditionLabel(options));
  table.Add("contestant", report.contestant.name);
  table.Add("kind", KindName(report.contestant.kind));
  table.Add("protocol", std::string(ProtocolName(options.protocol)));
  table.AddNumber<int>("episodes", options.episodes);
  table.AddNumber<std::uint64_t>("seed", options.seed);
  table.AddNumber<double>("speed_mps", options.speed_mps);
  table.AddNumber<double>("warmup_s", result.warmup_s);
  table.AddNumber<double>("window_s", result.window_s);
  table.AddNumber<std::int64_t>("decisions", result.decisions());
  AddSample(table, {"agi_s", "agi_ci95_s", "agi_sd_s"}, result.agi_s());
  AddSample(table, {"wi_s", "wi_ci95_s", "wi_sd_s"}, result.wi_s());
  AddSample(table, {"final_s", "final_ci95_s", "final_sd_s"}, result.final_s());
  table.AddNumber<double>("lower_bound_agi_s", report.bounds.agi_s);
  table.AddNumber<double>("lower_bound_wi_s", report.bounds.wi_s);
  table.AddNumber<double>("agi_to_lower_bound", ratios.agi_to_bound.mean);
  table.AddNumber("agi_to_lower_bound_ci95", ratios.agi_to_bound.ci95);
  table.AddNumber<double>("wi_to_lower_bound", ratios.wi_to_bound.mean);
  table.AddNumber("wi_to_lower_bound_ci95", ratios.wi_to_bound.ci95);
  table.Add("best_classical", best == nullptr ? "" : best->contestant.name);
  table.AddNumber("to_best_classical", to_best ? std::optional(to_best->mean) : std::nullopt);
  table.AddNumber("to_best_classical_ci95", to_best ? to_best->ci95 : std::nullopt);
  table.AddNumber("ratio_to_random", report.ratio_to_random);
  table.EndRow();
}

}  // namespace

std::string ResultsCsv(const Matrix& matrix) {
  CsvTable table;
  for (const Comparison& comparison : matrix) {
    const EvaluationReport* best = BestClassicalOf(comparison);
    for (const EvaluationReport& report : comparison) AddRow(table, report, best);
  }
  return table.Text();
}

void WriteEpisodesCsv(const Matrix& matrix, OutputFile& file) {
  file.Write("map,agents,condition,contestant,kind,episode,agi_s,wi_s,final_s,decisions\n");
  for (const Comparison& comparison : matrix) {
    for (const EvaluationReport& report : comparison) {
      const std::string cell =
          fmt::format("{},{},{},{},{}", CsvField(report.map), report.options.agents,
                      CsvField(ConditionLabel(report.options)), CsvField(report.contestant.name),
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
