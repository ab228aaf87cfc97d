#pragma once
// The folder of `ronda compare --out`: cells.jsonl, results.{csv,json,md}, episodes.csv, pictures.
//
// Held by one process at a time (common/run/folder_lock.h). A folder that holds other things and no
// cells.jsonl, or those of another comparison, is refused and left as it is (UsageError). Results
// appear each whole or not at all. Thread-compatible.
#include <filesystem>
#include <stop_token>
#include <string>

#include "common/evaluation/matrix.h"
#include "common/run/folder_lock.h"
#include "deploy/cell_journal.h"

namespace ronda {

class ComparisonFolder {
 public:
  /// Makes the folder where it is missing. `identity`, and errors beside: CellJournal.
  ComparisonFolder(const std::filesystem::path& path, const std::string& identity);

  CellJournal& journal() { return journal_; }
  /// Throws UsageError with path and reason where a file cannot be written.
  void WriteResults(const Matrix& matrix) const;
  /// Pictures of the results, by python/figures.py. Throws InputError with the reason where
  /// they cannot be drawn: python3 or matplotlib is missing. Returns early when stopped.
  void DrawFigures(const std::stop_token& stop) const;

 private:
  std::filesystem::path path_;
  FolderLock lock_;
  CellJournal journal_;
};

}  // namespace ronda
