#include "common/evaluation/report.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/evaluation/comparison.h"
#include "common/evaluation/output_file.h"
#include "tests/temporary_folder.h"
#include "tests/unit/example_report.h"

namespace ronda {
namespace {

using testing::ReportOf;

std::set<std::string> Keys(const nlohmann::json& json) {
  std::set<std::string> keys;
  for (const auto& item : json.items()) keys.insert(item.key());
  return keys;
}

TEST_CASE("The JSON of a report has the documented keys and values") {
  const auto sut =
      nlohmann::json::parse(ReportAsJson(ReportOf({.name = "cr"}, {1.0, 2.0, 3.0, 4.0})));

  CHECK(Keys(sut) == std::set<std::string>{"map", "agents", "strategy", "speed_mps", "noise",
                                           "conditions", "seed", "protocol", "episodes", "t_ref_s",
                                           "warmup_s", "window_s", "decisions", "agi_s", "wi_s",
                                           "final_s", "lower_bound_agi_s", "lower_bound_wi_s"});
  CHECK(sut["map"] == "somewhere");
  CHECK(sut["agents"] == 3);
  CHECK(sut["strategy"] == "cr");
  CHECK(sut["speed_mps"] == 2.0);
  CHECK(sut["noise"] == 0.25);
  CHECK(sut["conditions"]["label"] == "speed 2 m/s, noise 0.25");
  CHECK(sut["conditions"]["message_range_m"].is_null());
  CHECK(sut["seed"] == 9);
  CHECK(sut["protocol"] == "steady");
  CHECK(sut["episodes"] == 4);
  CHECK(sut["t_ref_s"] == 5.0);
  CHECK(sut["warmup_s"] == 100.0);
  CHECK(sut["window_s"] == 300.0);
  CHECK(sut["decisions"] == 28);
  CHECK(sut["agi_s"]["mean"] == 2.5);
  CHECK(sut["agi_s"]["ci95"].get<double>() == Approx(2.054260).epsilon(1e-6));
  CHECK(sut["wi_s"]["mean"] == 25.0);
  CHECK(sut["final_s"]["mean"] == 5.0);
  CHECK(sut["lower_bound_agi_s"] == 2.0);
  CHECK(sut["lower_bound_wi_s"] == 4.0);
}

TEST_CASE("One episode has a null interval, a policy its own key, the thesis protocol its ratio") {
  auto report = ReportOf({.kind = ContestantKind::kPolicy, .name = "runs/a"}, {2.0});
  report.options.protocol = Protocol::kThesis;
  report.ratio_to_random = 3.5;

  const auto sut = nlohmann::json::parse(ReportAsJson(report));

  CHECK(sut["agi_s"]["ci95"].is_null());
  CHECK(sut["policy"] == "runs/a");
  CHECK_FALSE(sut.contains("strategy"));
  CHECK(sut["protocol"] == "thesis");
  CHECK(sut["ratio_to_random"] == 3.5);
}

TEST_CASE("Where no bound is known none is printed, and it is said why") {
  auto report = ReportOf({.name = "cr"}, {1.0, 2.0});
  report.bounds.reset();

  const auto json = nlohmann::json::parse(ReportAsJson(report));
  const std::string text = FormatReport(report);
  const std::string table = FormatComparison(std::vector<EvaluationReport>{report});

  CHECK(json["lower_bound_agi_s"].is_null());
  CHECK(json["lower_bound_wi_s"].is_null());
  for (const std::string& sut : {text, table}) {
    CHECK_THAT(sut, !Catch::Contains("lower bound") && !Catch::Contains("AGI to bound") &&
                        Catch::Contains("No bound is known where robots are repaired"));
  }
}

TEST_CASE("Comparison: nothing is compared to a bound of 0") {
  auto report = ReportOf({.name = "cr"}, {1.0, 2.0});
  report.bounds = LowerBounds{};
  const std::string sut = FormatComparison(std::vector<EvaluationReport>{report});
  CHECK_THAT(sut, Catch::Contains("lower bound") && !Catch::Contains("inf"));
}

TEST_CASE("The text of a report names protocol, window, episodes, seed, noise and bounds") {
  const std::string sut = FormatReport(ReportOf({.name = "cr"}, {1.0, 2.0, 3.0, 4.0}));

  for (const char* part : {"somewhere", "3 robots at 2 m/s", "noise 0.25", "steady protocol",
                           "window 300 s (60 T_ref)", "4 episodes, seed 9", "strategy cr",
                           "2.50 ± 2.05 s", "lower bound 2.00 s", "lower bound 4.00 s"}) {
    CHECK_THAT(sut, Catch::Contains(part));
  }
}

TEST_CASE("Comparison: the best classical strategy is that of the headline figure") {
  std::vector<EvaluationReport> reports{
      ReportOf({.kind = ContestantKind::kPolicy, .name = "net"}, {1.0, 1.0}),
      ReportOf({.name = "cr"}, {6.0, 8.0}), ReportOf({.name = "er"}, {3.0, 5.0})};
  CHECK(BestClassical(reports) == &reports[2]);

  for (auto& report : reports) report.options.protocol = Protocol::kThesis;
  reports[1].result.episodes[0].final_s = 0.5;
  reports[1].result.episodes[1].final_s = 0.5;
  CHECK(BestClassical(reports) == &reports[1]);

  CHECK(BestClassical(std::span(reports).first(1)) == nullptr);
}

TEST_CASE("Comparison: the table pairs ratios by episode") {
  const std::vector<EvaluationReport> reports{
      ReportOf({.kind = ContestantKind::kPolicy, .name = "net"}, {1.5, 2.5}),
      ReportOf({.name = "er"}, {3.0, 5.0})};

  const std::string table = FormatComparison(reports);

  CHECK_THAT(table, Catch::Contains("0.500 ± 0.000"));  // to er
  CHECK_THAT(table, Catch::Contains("2.000 ± "));       // er to the bound
  CHECK_THAT(table, Catch::Contains("seed 9"));
  CHECK_THAT(table, Catch::Contains("lower bound"));
}

TEST_CASE("An output file appears whole, or not at all") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "result.json";
  {
    OutputFile abandoned(path);
    abandoned.Write("half");
  }
  CHECK(std::filesystem::is_empty(folder.path()));

  OutputFile sut(path);
  sut.Write("whole\n");
  CHECK_FALSE(std::filesystem::exists(path));
  sut.Commit();

  std::string line;
  std::getline(std::ifstream(path), line);
  CHECK(line == "whole");
}

TEST_CASE("A path that cannot be written is refused at once, with path and reason") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "missing" / "result.json";

  CHECK_THROWS_WITH(OutputFile(path),
                    Catch::StartsWith(path.string()) && Catch::Contains("No such file"));
  CHECK_THROWS_AS(OutputFile(folder.path()), UsageError);  // a folder
}

}  // namespace
}  // namespace ronda
