#include "deploy/matrix_text.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "deploy/matrix_progress.h"
#include "tests/unit/example_report.h"

namespace ronda {
namespace {

using testing::ReportOf;

/// random and cr, of which random is better from `turn` robots on.
Matrix ExampleMatrix(int team_sizes, int turn) {
  Matrix matrix;
  for (int agents = 1; agents <= team_sizes; ++agents) {
    Comparison comparison{ReportOf({.name = "random"}, {agents < turn ? 30.0 : 10.0}),
                          ReportOf({.name = "cr"}, {20.0})};
    for (EvaluationReport& report : comparison) report.options.agents = agents;
    matrix.push_back(comparison);
  }
  return matrix;
}

TEST_CASE("A matrix as text: contestants by team size, the best marked, the bound below") {
  const std::string sut = MatrixAsText(ExampleMatrix(2, 2), {});

  CHECK_THAT(sut,
             Catch::StartsWith("somewhere, speed 2 m/s, noise 0.25\nsteady protocol: warm-up 20, "
                               "window 60 T_ref of 5 s / N; robots at 2 m/s; 1 episode of "
                               "seed 9\n\n"));
  CHECK_THAT(sut, Catch::Contains("AGI (s)\n"
                                  "               N=1     N=2\n"
                                  "random       30.00   10.00*\n"
                                  "cr           20.00*  20.00\n"
                                  "lower bound   2.00    2.00\n"));
  CHECK_THAT(sut, Catch::Contains("WI (s)\n"));
  CHECK_THAT(sut, Catch::Contains("AGI to that of the best classical strategy\n"
                                  "          N=1     N=2\n"
                                  "random  1.500   1.000*\n"
                                  "cr      1.000*  2.000\n"));
}

TEST_CASE("Tables wider than the terminal go on below with the next team sizes") {
  for (const int columns : {1, 40, 60, 100}) {
    CAPTURE(columns);
    const std::string sut = MatrixAsText(ExampleMatrix(20, 7), {.columns = columns});
    std::istringstream lines(sut);
    int columns_seen = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.find(" N=") == std::string::npos) continue;
      if (columns > 1) CHECK(DisplayColumns(line) <= columns);
      for (std::size_t at = 0; (at = line.find("N=", at)) != std::string::npos; ++at) {
        ++columns_seen;
      }
    }
    CHECK(columns_seen == 3 * 20);  // AGI, WI and ratios
  }
}

TEST_CASE("Only a colour style writes escape sequences, and names cannot") {
  Matrix matrix = ExampleMatrix(1, 2);
  matrix[0][0].contestant.name = "evil\x1b[2J";

  CHECK(MatrixAsText(matrix, {}).find('\x1b') == std::string::npos);
  const std::string coloured = MatrixAsText(matrix, {.style = ViewStyle::kColour});
  CHECK(coloured.find("\x1b[1m") != std::string::npos);
  CHECK(coloured.find("\x1b[2J") == std::string::npos);
}

TEST_CASE("Progress tells cells, share, time so far, time left and what is played") {
  MatrixStatus status{.cells = 16,
                      .cells_done = 3,
                      .work = 100.0,
                      .work_done = 20.0,
                      .present = "grid, 4 robots: er"};

  CHECK(DescribeProgress(status, 5.0) == "3/16 cells   20 %  5.0 s, 20 s left  grid, 4 robots: er");
  CHECK(DescribeProgress(status, 0.5).find("left") == std::string::npos);
  status.work = status.work_done = 0.0;  // all was done before
  CHECK_THAT(DescribeProgress(status, 2.0), Catch::Contains("100 %"));
}

}  // namespace
}  // namespace ronda
