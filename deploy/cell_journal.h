#pragma once
// What a comparison has finished, so that it can be gone on with: cells.jsonl, one cell a line.
//
// A line is {"results_version", "cell": all that determines the result, "t_ref_s", "warmup_s",
// "window_s", "episodes": [[agi_s, wi_s, final_s, decisions], …]}; numbers read back to the same
// doubles. A line is written as soon as its cell is done, in one piece. One that was torn (a kill,
// a full disk) is no JSON and skipped; of equal cells the last counts. Errors: InputError with
// file, line and rule for what is JSON but no finished cell, and where the file cannot be read or
// written. Thread-compatible.
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "common/evaluation/report.h"
#include "common/run/appended_lines.h"

namespace ronda {

/// Raised whenever worlds, strategies or protocols begin to give other results for the same cell.
inline constexpr int kResultsVersion = 1;

/// What determines a cell beside what its report says.
struct CellInputs {
  std::string map_fingerprint;
  std::string length;              // of edges, as the option
  std::string policy_fingerprint;  // empty for a strategy
};

/// Equal exactly where the results are: names of maps and policies do not count, their files do,
/// and for policies the kernel that computes them. `report` needs no result.
std::string CellKey(const EvaluationReport& report, const CellInputs& inputs);

class CellJournal {
 public:
  explicit CellJournal(const std::filesystem::path& path);

  /// nullopt where the cell is not finished. `key`: CellKey.
  std::optional<EvaluationResult> Find(const std::string& key) const;
  void Append(const std::string& key, const EvaluationResult& result);

 private:
  std::map<std::string, EvaluationResult> finished_;
  AppendedLines lines_;
};

}  // namespace ronda
