#pragma once
// What a comparison has finished, so that it can be gone on with: cells.jsonl.
//
// The first line is the comparison's identity (matrix_plan.h), each other one a finished cell:
// {"cell": its place, "episodes": [[agi_s, wi_s, final_s, decisions], …]}; numbers read back to the
// same doubles. A line is written as soon as its cell is done, in one piece; one that was torn (a
// kill, a full disk) is no JSON and skipped. Errors: UsageError with the first key that differs
// where the file is of another comparison; InputError with file, line and rule for what is JSON but
// no finished cell, and where the file cannot be read or written. Thread-compatible.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/evaluation/protocol.h"
#include "common/run/appended_lines.h"

namespace ronda {

class CellJournal {
 public:
  /// `identity`: a JSON object in one line.
  CellJournal(const std::filesystem::path& path, const std::string& identity);

  /// nullopt where the cell is not finished.
  std::optional<std::vector<EpisodeResult>> Find(std::size_t cell) const;
  void Append(std::size_t cell, const std::vector<EpisodeResult>& episodes);

 private:
  std::map<std::size_t, std::vector<EpisodeResult>> finished_;
  AppendedLines lines_;
};

}  // namespace ronda
