// `ronda compare` on many settings as a user meets it: results that a cut journal does not change,
// folders that are refused.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "common/base/whole_file.h"
#include "common/run/folder_lock.h"
#include "tests/temporary_folder.h"
#include "tests/unit/random_policy.h"
#include "tests/unit/ronda_program.h"

namespace ronda {
namespace {

using testing::Ronda;

const std::string kMatrix =
    "compare --map 4nodes,grid --agents 2,3 --noise 0,0.1 --strategies random,cr,cyclic "
    "--episodes 2 ";

std::multiset<std::string> LinesOf(const std::string& text) {
  std::istringstream stream(text);
  std::multiset<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  return lines;
}

/// Contents of the files of results in a folder.
std::map<std::string, std::string> ResultsIn(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const char* name : {"results.csv", "results.json", "results.md", "episodes.csv"}) {
    contents[name] = ReadWholeFile(folder / name);
  }
  return contents;
}

TEST_CASE("A matrix that was cut short and gone on with gives the bytes of one that was not") {
  const TemporaryFolder folder;
  const auto whole = folder / "whole";
  const auto resumed = folder / "resumed";
  const auto first = Ronda(kMatrix + "--out " + whole.string());
  REQUIRE(first.status == 0);
  const auto expected = ResultsIn(whole);
  CHECK(LinesOf(expected.at("results.csv")).size() == 1 + 2 * 2 * 2 * 3);
  CHECK(LinesOf(expected.at("episodes.csv")).size() == 1 + 2 * 2 * 2 * 3 * 2);
  const std::string journal = ReadWholeFile(whole / "cells.jsonl");

  for (const std::size_t kept : {std::size_t{0}, journal.size() / 3, journal.size() - 1}) {
    CAPTURE(kept);
    std::filesystem::remove_all(resumed);
    std::filesystem::create_directory(resumed);
    WriteWholeFile(resumed / "cells.jsonl", journal.substr(0, kept));
    const auto again = Ronda(kMatrix + "--out " + resumed.string());
    CHECK(again.status == 0);
    CHECK(again.output == first.output);
    CHECK(ResultsIn(resumed) == expected);
    CHECK_THAT(ReadWholeFile(resumed / "cells.jsonl"), Catch::StartsWith(journal.substr(0, kept)));
  }
}

TEST_CASE("Finished cells are not played again, also in another matrix of the same folder") {
  const TemporaryFolder folder;
  const std::string out = "--out " + (folder / "out").string();
  REQUIRE(Ronda(kMatrix + out).status == 0);
  const std::string journal = ReadWholeFile(folder / "out/cells.jsonl");

  CHECK(Ronda("compare --map grid --agents 3 --strategies cyclic,cr --episodes 2 " + out).status ==
        0);
  CHECK(ReadWholeFile(folder / "out/cells.jsonl") == journal);
  CHECK(LinesOf(ReadWholeFile(folder / "out/results.csv")).size() == 3);

  CHECK(Ronda("compare --map grid --agents 3 --strategies cyclic --episodes 3 " + out).status == 0);
  CHECK(LinesOf(ReadWholeFile(folder / "out/cells.jsonl")).size() == LinesOf(journal).size() + 1);
}

TEST_CASE("The order of the lists changes the order of the results, and nothing else") {
  const auto forth = Ronda(kMatrix + "--format csv");
  const auto back = Ronda(
      "compare --noise 0.1,0 --agents 3 --agents 2 --strategies cyclic,random --strategies cr "
      "--map grid --map 4nodes --episodes 2 --format csv");
  REQUIRE(forth.status == 0);
  CHECK(forth.output != back.output);
  CHECK(LinesOf(forth.output) == LinesOf(back.output));
}

TEST_CASE("Many settings come as tables, markdown, CSV or JSON") {
  CHECK_THAT(Ronda(kMatrix).output,
             Catch::Contains("grid, noise 0.1\n") && Catch::Contains("lower bound"));
  CHECK_THAT(Ronda(kMatrix + "--ratio-to best-classical").output,
             Catch::Contains("AGI to that of the best classical strategy"));
  CHECK_THAT(Ronda(kMatrix + "--format markdown").output, Catch::StartsWith("## 4nodes\n"));
  CHECK_THAT(Ronda(kMatrix + "--format csv").output, Catch::StartsWith("map,agents,condition,"));
  CHECK_THAT(Ronda(kMatrix + "--format json").output, Catch::StartsWith("[\n"));
}

TEST_CASE("The thesis protocol gives ratios to the random walk, which need not be shown") {
  const TemporaryFolder folder;
  const auto result = Ronda(
      "compare --map 4nodes --agents 2,3 --strategies cr --protocol thesis --horizon 100 "
      "--episodes 2 --format csv");
  CHECK(result.status == 0);
  CHECK(LinesOf(result.output).size() == 3);
  CHECK(result.output.find("random,") == std::string::npos);
  for (const std::string& line : LinesOf(result.output)) CHECK(line.back() != ',');
}

TEST_CASE("A folder that another process holds is refused, and so is one of other things") {
  const TemporaryFolder folder;
  {
    const FolderLock held(folder / "held", "the folder");
    const auto result = Ronda(kMatrix + "--out " + (folder / "held").string());
    CHECK(result.status == 8);
    CHECK_THAT(result.output, Catch::Contains("held: the folder is in use by process"));
  }
  std::filesystem::create_directory(folder / "foreign");
  WriteWholeFile(folder / "foreign/results.csv", "mine");
  const auto result = Ronda(kMatrix + "--out " + (folder / "foreign").string());
  CHECK(result.status == 2);
  CHECK_THAT(result.output, Catch::Contains("--out must be") && Catch::Contains("results.csv"));
  CHECK(ReadWholeFile(folder / "foreign/results.csv") == "mine");

  WriteWholeFile(folder / "held/cells.jsonl", "{\"time_s\":1}\n");
  CHECK(Ronda(kMatrix + "--out " + (folder / "held").string()).status == 3);
  CHECK(ReadWholeFile(folder / "held/cells.jsonl") == "{\"time_s\":1}\n");
}

TEST_CASE("Bad lists end with status 2, the option and the value, before anything is played") {
  struct Case {
    const char* arguments;
    const char* says;
  };
  for (const Case& bad :
       {Case{"--map 4nodes --agents 4..2 --strategies cr", "--agents must be"},
        Case{"--map 4nodes --agents 2,four --strategies cr", "got 'four'"},
        Case{"--map 4nodes --agents 2 --noise 0,x --strategies cr", "--noise must be"},
        Case{"--map 4nodes --agents 2 --noise 0,-1 --strategies cr", "got '-1'"},
        Case{"--map 4nodes --agents 2 --strategies cr,nobody", "nobody"},
        Case{"--map 4nodes --agents 2", "nothing to compare"},
        Case{"--map 4nodes --agents 2 --strategies cr --format pdf", "--format"},
        Case{"--map 4nodes --agents 2 --strategies cr --figures", "--out"}}) {
    CAPTURE(bad.arguments);
    const auto result = Ronda(std::string("compare ") + bad.arguments);
    CHECK(result.status == 2);
    CHECK_THAT(result.output, Catch::Contains(bad.says));
  }
  CHECK(Ronda("compare --map 4nodes,atlantis --agents 2 --strategies cr").status == 3);
}

TEST_CASE("A policy for another team is refused by map, team and name before anything is played") {
  const TemporaryFolder folder;
  const std::string policy = (folder / "matrix.ronda").string();
  const testing::EvaluationMap map("4nodes");
  WritePolicyFile(policy, testing::RandomPolicy(ObservationScheme::kMatrix, map, 2));
  const std::string compare =
      "compare --map 4nodes --policy " + policy + " --strategies cr --episodes 2 --format csv ";

  const auto refused = Ronda(compare + "--agents 2,3 --out " + (folder / "out").string());
  CHECK(refused.status == 3);
  CHECK_THAT(refused.output, Catch::Contains("4nodes, 3 robots: " + policy) &&
                                 Catch::Contains("a team of 2 robots, this one has 3"));
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
  CHECK(LinesOf(Ronda(compare + "--agents 2").output).size() == 3);
}

TEST_CASE("A policy that was trained further is played again, the strategies beside it are not") {
  const TemporaryFolder folder;
  const std::string policy = (folder / "a.ronda").string();
  const testing::EvaluationMap map("4nodes");
  PolicyFile trained = testing::RandomPolicy(ObservationScheme::kSorted, map, 2);
  const std::string compare =
      "compare --map 4nodes --agents 2 --strategies cr --episodes 2 --policy " + policy +
      " --out " + (folder / "out").string();
  const auto cells_after = [&] {
    WritePolicyFile(policy, trained);
    CHECK(Ronda(compare).status == 0);
    return LinesOf(ReadWholeFile(folder / "out/cells.jsonl")).size();
  };
  CHECK(cells_after() == 2);
  CHECK(cells_after() == 2);
  trained.weights[0] += 1.0f;
  CHECK(cells_after() == 3);
}

TEST_CASE("Figures are drawn into the folder; where they cannot be, the results stay") {
  const TemporaryFolder folder;
  const std::string matrix = "compare --map " RONDA_SOURCE_DIR
                             "/maps/4nodes.json --agents 2,3 --strategies random,cr --episodes 2 "
                             "--figures --out ";
  const auto drawn = Ronda(matrix + (folder / "drawn").string());
  CHECK(drawn.status == 0);
  for (const char* name :
       {"agi.svg", "agi.png", "agi_to_lower_bound.svg", "wi.svg", "agi_ratios.png"}) {
    CHECK(std::filesystem::file_size(folder / "drawn" / name) > 1000);
  }
  CHECK_FALSE(std::filesystem::exists(folder / "drawn/figures.log"));

  const auto missing =
      Ronda(matrix + (folder / "missing").string(), "RONDA_HOME=" + folder.path().string());
  CHECK(missing.status == 3);
  CHECK_THAT(missing.output, Catch::Contains("the figures could not be drawn: ") &&
                                 Catch::Contains("the results stand in "));
  CHECK(std::filesystem::exists(folder / "missing/results.csv"));
}

}  // namespace
}  // namespace ronda
