#include "deploy/cell_journal.h"

#include <catch2/catch.hpp>
#include <limits>

#include "common/base/error.h"
#include "common/base/fingerprint.h"
#include "common/base/whole_file.h"
#include "tests/temporary_folder.h"
#include "tests/unit/example_report.h"

namespace ronda {
namespace {

using testing::ReportOf;

const CellInputs kInputs{
    .map_fingerprint = "map", .length = "euclidean", .policy_fingerprint = "policy"};

/// A result whose numbers are no short decimals.
EvaluationReport AwkwardReport() {
  EvaluationReport report = ReportOf({.name = "cr"}, {1.0 / 3.0, 1e-300});
  report.options.seed = std::numeric_limits<std::uint64_t>::max();
  report.result.t_ref_s = 0.1 + 0.2;
  report.result.episodes[0].wi_s = std::numeric_limits<double>::denorm_min();
  report.result.episodes[1].decisions = std::numeric_limits<std::int64_t>::max();
  return report;
}

void CheckSame(const EvaluationResult& a, const EvaluationResult& b) {
  CHECK(a.t_ref_s == b.t_ref_s);
  CHECK(a.warmup_s == b.warmup_s);
  CHECK(a.window_s == b.window_s);
  CHECK(a.agi_s() == b.agi_s());
  CHECK(a.wi_s() == b.wi_s());
  CHECK(a.final_s() == b.final_s());
  REQUIRE(a.episodes.size() == b.episodes.size());
  CHECK(a.episodes.back().decisions == b.episodes.back().decisions);
}

TEST_CASE("A journal gives back each cell's result to the last bit, also when read again") {
  const TemporaryFolder folder;
  const EvaluationReport report = AwkwardReport();
  const std::string key = CellKey(report, kInputs);
  {
    CellJournal sut(folder / "cells.jsonl");
    CHECK_FALSE(sut.Find(key));
    sut.Append(key, report.result);
    REQUIRE(sut.Find(key));
  }
  const CellJournal again(folder / "cells.jsonl");
  REQUIRE(again.Find(key));
  CheckSame(*again.Find(key), report.result);
}

TEST_CASE("A line that was torn is no cell, and the next is appended whole") {
  const TemporaryFolder folder;
  const auto file = folder / "cells.jsonl";
  EvaluationReport report = AwkwardReport();
  const std::string first = CellKey(report, kInputs);
  CellJournal(file).Append(first, report.result);
  const std::string whole = ReadWholeFile(file);
  report.options.agents = 8;
  const std::string second = CellKey(report, kInputs);

  for (const std::size_t kept : {std::size_t{1}, whole.size() / 2, whole.size() - 2}) {
    CAPTURE(kept);
    WriteWholeFile(file, whole + whole.substr(0, kept));
    CHECK(CellJournal(file).Find(first));
    WriteWholeFile(file, whole.substr(0, kept));
    CellJournal sut(file);
    CHECK_FALSE(sut.Find(first));
    sut.Append(second, report.result);
    CHECK(CellJournal(file).Find(second));
  }
  WriteWholeFile(file, whole.substr(0, whole.size() - 1));  // all but the line's end
  CHECK(CellJournal(file).Find(first));
}

TEST_CASE("A journal's line that is JSON but no finished cell is refused by file and line") {
  const TemporaryFolder folder;
  const auto file = folder / "cells.jsonl";
  const EvaluationReport report = AwkwardReport();
  CellJournal(file).Append(CellKey(report, kInputs), report.result);
  std::string missing = ReadWholeFile(file);
  missing.erase(missing.rfind(",["), missing.rfind("]}") - missing.rfind(",["));  // an episode

  for (const std::string& line : {std::string("{\"time_s\":1}"), std::string("[1]"), missing}) {
    WriteWholeFile(file, "torn\n" + line + "\n");
    CHECK_THROWS_WITH(CellJournal(file),
                      Catch::StartsWith(file.string() + ":2: each line must be a finished cell"));
    CHECK_THROWS_AS(CellJournal(file), InputError);
  }
}

TEST_CASE("Results of another version of the program are not used") {
  const TemporaryFolder folder;
  const auto file = folder / "cells.jsonl";
  const EvaluationReport report = AwkwardReport();
  CellJournal(file).Append(CellKey(report, kInputs), report.result);
  std::string text = ReadWholeFile(file);
  const std::string version = "\"results_version\":";
  text.insert(text.find(version) + version.size(), "9");
  WriteWholeFile(file, text);

  CHECK_FALSE(CellJournal(file).Find(CellKey(report, kInputs)));
}

TEST_CASE("A cell is another one where anything that determines it differs, but for names") {
  const EvaluationReport strategy = ReportOf({.name = "cr"}, {1.0});
  const EvaluationReport policy =
      ReportOf({.kind = ContestantKind::kPolicy, .name = "runs/a"}, {1.0});
  const auto changed = [&](auto change) {
    EvaluationReport report = strategy;
    change(report);
    return CellKey(report, kInputs) != CellKey(strategy, kInputs);
  };
  CHECK(changed([](EvaluationReport& r) { r.contestant.name = "er"; }));
  CHECK(changed([](EvaluationReport& r) { r.options.agents = 9; }));
  CHECK(changed([](EvaluationReport& r) { r.options.travel_noise = 0.5; }));
  CHECK(changed([](EvaluationReport& r) { r.options.speed_mps = 0.5; }));
  CHECK(changed([](EvaluationReport& r) { r.options.episodes = 7; }));
  CHECK(changed([](EvaluationReport& r) { r.options.seed = 10; }));
  CHECK(changed([](EvaluationReport& r) { r.options.protocol = Protocol::kThesis; }));
  CHECK_FALSE(changed([](EvaluationReport& r) { r.map = "the same file"; }));
  CHECK_FALSE(changed([](EvaluationReport& r) { r.options.horizon_s = 7.0; }));  // steady
  CHECK_FALSE(changed([](EvaluationReport& r) { r.options.threads = 7; }));

  CellInputs other = kInputs;
  other.policy_fingerprint = "retrained";
  CHECK(CellKey(policy, other) != CellKey(policy, kInputs));
  CHECK(CellKey(strategy, other) == CellKey(strategy, kInputs));
  other = kInputs;
  other.map_fingerprint = "edited";
  CHECK(CellKey(strategy, other) != CellKey(strategy, kInputs));
  other = kInputs;
  other.length = "file";
  CHECK(CellKey(strategy, other) != CellKey(strategy, kInputs));
  EvaluationReport renamed = policy;
  renamed.contestant.name = "runs/b";
  CHECK(CellKey(renamed, kInputs) == CellKey(policy, kInputs));
}

TEST_CASE("A file's fingerprint is the CRC-32 of its bytes and their number") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "file", "123456789");
  CHECK(FileFingerprint(folder / "file") == "cbf43926-9");  // the check value of CRC-32
  CHECK_THROWS_AS(FileFingerprint(folder / "none"), InputError);
}

}  // namespace
}  // namespace ronda
