// `ronda compare` on many settings as a user meets it: results that a cut journal does not change,
// folders that are refused.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "common/base/whole_file.h"
#include "common/run/child_process.h"
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

/// Arguments of a comparison that takes about a second on one core.
std::vector<std::string> LongMatrix(const std::filesystem::path& out) {
  return {"compare",      "--map",        "4nodes,grid", "--agents", "1..12", "--noise",   "0,0.1",
          "--strategies", "random,cr,er", "--episodes",  "100",      "--out", out.string()};
}

std::string Joined(const std::vector<std::string>& arguments) {
  return fmt::format("{}", fmt::join(arguments, " "));
}

/// Empty where there is none yet.
std::string ReadWholeFileIfThere(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? ReadWholeFile(path) : "";
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

/// Plays until a few more cells are finished, and ends the process by `signal`.
ExitStatus Interrupt(const std::filesystem::path& out, int signal) {
  const auto lines = [&] { return LinesOf(ReadWholeFileIfThere(out / "cells.jsonl")).size(); };
  const std::size_t wanted = lines() + 4;
  ChildProcess ronda(RONDA_BIN_DIR "/ronda", LongMatrix(out), out.string() + ".log");
  while (lines() < wanted) {
    const auto early = ronda.WaitFor(std::chrono::milliseconds(1));
    if (early) return *early;
  }
  ronda.Signal(signal);
  std::optional<ExitStatus> status;
  while (!status) status = ronda.WaitFor(std::chrono::seconds(1));
  return *status;
}

TEST_CASE("A process that is stopped, then killed, is gone on with to the same bytes") {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  REQUIRE(Ronda(Joined(LongMatrix(folder / "whole"))).status == 0);

  CHECK(Interrupt(out, SIGINT).code == 130);
  CHECK_THAT(ReadWholeFile(out.string() + ".log"),
             Catch::Contains("cells done; they are kept in ") &&
                 Catch::Contains("the same command goes on"));
  CHECK(Interrupt(out, SIGKILL).signal == SIGKILL);
  CHECK_FALSE(std::filesystem::exists(out / "results.csv"));
  const std::string kept = ReadWholeFile(out / "cells.jsonl");

  CHECK(Ronda(Joined(LongMatrix(out))).status == 0);
  CHECK_THAT(ReadWholeFile(out / "cells.jsonl"), Catch::StartsWith(kept));
  CHECK(ResultsIn(out) == ResultsIn(folder / "whole"));
}

TEST_CASE("A folder of other settings, another version of a policy or of a map is refused") {
  const TemporaryFolder folder;
  const std::string policy = (folder / "a.ronda").string();
  const std::string map = (folder / "m.json").string();
  const testing::EvaluationMap nodes("4nodes");
  PolicyFile trained = testing::RandomPolicy(ObservationScheme::kSorted, nodes, 2);
  WritePolicyFile(policy, trained);
  WriteWholeFile(map, ReadWholeFile(RONDA_SOURCE_DIR "/maps/4nodes.json"));
  const std::string compare = "compare --strategies cr --episodes 2 --map " + map + " --policy " +
                              policy + " --out " + (folder / "out").string();
  REQUIRE(Ronda(compare + " --agents 2").status == 0);
  const auto results = ResultsIn(folder / "out");
  const auto check_refused = [&](const std::string& more, const char* says) {
    const auto result = Ronda(compare + more);
    CHECK(result.status == 2);
    CHECK_THAT(result.output,
               Catch::Contains("that of the same comparison") && Catch::Contains(says));
    CHECK(ResultsIn(folder / "out") == results);
  };

  CHECK(Ronda(compare + " --agents 2").status == 0);
  check_refused(" --agents 2,3", "'agents' was [2], got [2,3]");
  check_refused(" --agents 2 --noise 0.1", R"('conditions' was {}, got {"noise":"0.1"})");
  check_refused(" --agents 2 --seed 3", "'seed' was 1, got 3");
  check_refused(" --agents 2 --strategies er", R"('strategies' was ["cr"], got ["cr","er"])");
  WriteWholeFile(map, ReadWholeFile(map) + "\n");
  check_refused(" --agents 2", "'maps' was");
  WriteWholeFile(map, ReadWholeFile(RONDA_SOURCE_DIR "/maps/4nodes.json"));
  trained.weights[0] += 1.0f;
  WritePolicyFile(policy, trained);
  check_refused(" --agents 2", "'policies' was");
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
  CHECK_THAT(Ronda(kMatrix + "--format markdown").output, Catch::StartsWith("## 4nodes\n"));
  CHECK_THAT(Ronda(kMatrix + "--format csv").output, Catch::StartsWith("map,agents,conditions,"));
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
  CHECK(Ronda(kMatrix + "--out " + (folder / "held").string()).status == 2);
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
        Case{"--map 4nodes --agents 2 --noise 0,x --strategies cr", "noise: must be a number"},
        Case{"--map 4nodes --agents 2 --noise 0,-1 --strategies cr", "noise must be ≥ 0"},
        Case{"--map 4nodes --agents 2 --noise 0, --strategies cr", "--noise must be values"},
        Case{"--map 4nodes --agents 3,2 --fail 2@9 --strategies cr", "must be in 0 … 1, got 2"},
        Case{"--map 4nodes --agents 2 --repair 9 --strategies cr", "needs a mean time to failure"},
        Case{"--map 4nodes --agents 2 --priority nowhere=2 --strategies cr", "nowhere"},
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

TEST_CASE("Figures are drawn into the folder; where they cannot be, the results stay") {
  const TemporaryFolder folder;
  const std::string matrix = "compare --map " RONDA_SOURCE_DIR
                             "/maps/4nodes.json --agents 2,3 --strategies random,cr --episodes 2 "
                             "--figures --out ";
  const auto drawn = Ronda(matrix + (folder / "drawn").string());
  CHECK(drawn.status == 0);
  for (const char* name : {"agi.svg", "agi.png", "wi.svg", "agi_ratios.png"}) {
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
