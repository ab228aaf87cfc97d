#include "common/evaluation/matrix.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "common/evaluation/matrix_csv.h"
#include "common/evaluation/matrix_json.h"
#include "common/evaluation/matrix_markdown.h"
#include "tests/temporary_folder.h"
#include "tests/unit/example_report.h"

namespace ronda {
namespace {

using testing::ReportOf;

struct ExampleSetting {
  std::string map;
  double noise;
  int agents;
};

/// er with AGI 3 and 5, and a policy with 1.5 and 2.5, over the number of robots.
Comparison Example(const ExampleSetting& setting) {
  const auto n = static_cast<double>(setting.agents);
  Comparison comparison{
      ReportOf({.name = "er"}, {3.0 / n, 5.0 / n}),
      ReportOf({.kind = ContestantKind::kPolicy, .name = "runs/a|b"}, {1.5 / n, 2.5 / n})};
  for (EvaluationReport& report : comparison) {
    report.map = setting.map;
    report.options.conditions = {.travel_noise = setting.noise};
    report.options.agents = setting.agents;
    report.bounds = LowerBounds{.agi_s = 1.0 / n, .wi_s = 2.0 / n};
  }
  return comparison;
}

Matrix ExampleMatrix() {
  return {Example({"one", 0.0, 1}), Example({"one", 0.0, 2}), Example({"one", 0.1, 1}),
          Example({"two, or not", 0.1, 1})};
}

TEST_CASE("Panels: settings that differ in team size only stand together") {
  const Matrix matrix = ExampleMatrix();

  const auto sut = Panels(matrix);

  REQUIRE(sut.size() == 3);
  CHECK(sut[0].size() == 2);
  CHECK(PanelName(sut[0][0][0]) == "one");
  CHECK(PanelName(sut[1][0][0]) == "one, noise 0.1");
  CHECK(PanelName(sut[2][0][0]) == "two, or not, noise 0.1");
}

TEST_CASE("A table has a row a contestant, a column a team size, the best and the bound") {
  const Matrix matrix = ExampleMatrix();
  const auto panel = Panels(matrix)[0];

  const MatrixTable agi = TableOf(panel, Metric::kAgi);
  CHECK(agi.title == "AGI (s)");
  CHECK(agi.agents == std::vector<int>{1, 2});
  REQUIRE(agi.rows.size() == 2);
  CHECK(agi.rows[0].values[1].mean == 2.0);
  CHECK(agi.rows[1].values[1].mean == 1.0);
  CHECK(agi.best == std::vector<std::size_t>{1, 1});
  CHECK(agi.lower_bound == std::vector<double>{1.0, 0.5});

  const MatrixTable wi = TableOf(panel, Metric::kWi);
  CHECK(wi.rows[0].values[1].mean == 20.0);
  CHECK(wi.lower_bound == std::vector<double>{2.0, 1.0});

  const MatrixTable to_best = TableOf(panel, Metric::kRatio);
  CHECK(to_best.rows[0].values[0].mean == 1.0);
  CHECK(to_best.rows[1].values[0].mean == 0.5);
  CHECK(to_best.rows[1].values[0].ci95 == Approx(0.0).margin(1e-12));  // paired
  CHECK(to_best.lower_bound.empty());
}

TEST_CASE("The thesis protocol puts the final idleness first, which has no bound") {
  Comparison comparison = Example({"one", 0.0, 1});
  for (EvaluationReport& report : comparison) report.options.protocol = Protocol::kThesis;

  CHECK(MetricsOf({&comparison, 1}) ==
        std::vector{Metric::kFinal, Metric::kAgi, Metric::kWi, Metric::kRatio});
  const MatrixTable sut = TableOf({&comparison, 1}, Metric::kFinal);
  CHECK(sut.title == "final idleness (s)");
  CHECK(sut.rows[0].values[0].mean == 8.0);
  CHECK(sut.lower_bound.empty());
}

TEST_CASE("Without a classical strategy there are no ratios to one") {
  const Comparison policies{Example({"one", 0.0, 1})[1]};
  CHECK(MetricsOf({&policies, 1}) == std::vector{Metric::kAgi, Metric::kWi});
}

TEST_CASE("The JSON of a matrix has a report's keys and ratios") {
  const auto sut = nlohmann::json::parse(MatrixAsJson(ExampleMatrix()));

  REQUIRE(sut.size() == 8);
  CHECK(sut[0]["strategy"] == "er");
  CHECK(sut[5]["policy"] == "runs/a|b");
  CHECK(sut[5]["conditions"]["label"] == "noise 0.1");
  CHECK(sut[5]["best_classical"] == "er");
  CHECK(sut[5]["to_best_classical"]["mean"] == 0.5);
  CHECK(sut[5]["agi_to_lower_bound"]["mean"] == 2.0);
  CHECK(sut[5]["wi_to_lower_bound"]["mean"] == 10.0);
}

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_CASE("The CSV of results has a header and a row a cell, with what does not exist empty") {
  Matrix matrix = ExampleMatrix();
  for (Comparison& comparison : matrix) comparison.erase(comparison.begin());  // er
  for (EvaluationReport& report : matrix[0]) {
    report.result.episodes.pop_back();
    report.options.episodes = 1;
  }

  const auto sut = Lines(ResultsCsv(matrix));

  REQUIRE(sut.size() == 5);
  CHECK(sut[0] ==
        "map,agents,conditions,contestant,kind,protocol,episodes,seed,warmup_s,window_s,decisions,"
        "agi_s,agi_ci95_s,wi_s,wi_ci95_s,final_s,final_ci95_s,lower_bound_agi_s,lower_bound_wi_s,"
        "agi_to_lower_bound,agi_to_lower_bound_ci95,wi_to_lower_bound,wi_to_lower_bound_ci95,"
        "best_classical,to_best_classical,to_best_classical_ci95,ratio_to_random");
  CHECK(sut[1] == "one,1,,runs/a|b,policy,steady,1,9,100,300,7,1.5,,15,,3,,1,2,1.5,,7.5,,,,,");
  CHECK_THAT(sut[4], Catch::StartsWith("\"two, or not\",1,noise 0.1,runs/a|b,policy,steady,2,9,"));
}

TEST_CASE("The CSV of episodes has a row an episode, whose numbers read back to the same doubles") {
  const TemporaryFolder folder;
  Matrix matrix{Example({"one", 0.0, 3})};
  const double third_s = matrix[0][0].result.episodes[1].agi_s = 1.0 / 3.0;
  OutputFile file(folder / "episodes.csv");
  WriteEpisodesCsv(matrix, file);
  file.Commit();

  std::ifstream stream(folder / "episodes.csv");
  const auto sut = Lines({std::istreambuf_iterator<char>(stream), {}});

  REQUIRE(sut.size() == 5);
  CHECK(sut[0] == "map,agents,conditions,contestant,kind,episode,agi_s,wi_s,final_s,decisions");
  const std::string begin = "one,3,,er,strategy,1,";
  REQUIRE_THAT(sut[2], Catch::StartsWith(begin));
  CHECK(std::stod(sut[2].substr(begin.size())) == third_s);
}

TEST_CASE("Markdown: caption, intervals, the best in bold, the bound, ratios, no broken cells") {
  const std::string sut = MatrixAsMarkdown(ExampleMatrix());

  for (const char* part :
       {"## one, noise 0.1\n", "one: AGI (s). Mean ± 95 % interval by number N of robots",
        "window 60 T_ref", "2 episodes of seed 9", "| | N = 1 | N = 2 |\n|---|--:|--:|\n",
        "| er | 4.000 ± 12.706 | 2.000 ± 6.353 |", "| runs/a\\|b | **2.000 ± 6.353** |",
        "| lower bound | 1.000 | 0.500 |", "one: WI (s).",
        "one: AGI to that of the best classical strategy.", "| **0.500 ± 0.000** |"}) {
    CAPTURE(part);
    CHECK_THAT(sut, Catch::Contains(part));
  }
}

}  // namespace
}  // namespace ronda
