#include "deploy/comparison_folder.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "common/base/error.h"
#include "common/evaluation/matrix_csv.h"
#include "common/evaluation/matrix_json.h"
#include "common/evaluation/matrix_markdown.h"
#include "common/run/child_process.h"
#include "common/run/paths.h"

namespace ronda {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJournal = "cells.jsonl";
constexpr const char* kLock = "lock";
constexpr const char* kPython = "/usr/bin/python3";  // Debian's, for which setup.sh has matplotlib

/// The path, where what is there may be used.
const fs::path& CheckedFolder(const fs::path& path) {
  std::error_code error;  // what cannot be looked at is refused when the folder is taken
  if (fs::exists(path / kJournal, error)) return path;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    if (entry.path().filename() == kLock) continue;
    throw UsageError(
        fmt::format("--out must be a new or empty folder, or that of a comparison (with {}); {} "
                    "holds {}",
                    kJournal, path.string(), entry.path().filename().string()));
  }
  return path;
}

/// Why there are no figures; empty where there are, or when stopped.
std::string RunFigures(const fs::path& folder, const fs::path& log, const std::stop_token& stop) {
  const fs::path script = HomeFolder() / "python" / "figures.py";
  try {
    ChildProcess child(kPython, {script.string(), "compare", folder.string()}, log);
    std::optional<ExitStatus> status;
    while (!status && !stop.stop_requested())
      status = child.WaitFor(std::chrono::milliseconds(100));
    if (!status || (status->code == 0 && status->signal == 0)) return "";
    const auto last = child.LastLogLines(1);
    return last.empty() ? status->Description() : last.back();
  } catch (const Error& failure) {
    return failure.what();
  }
}

void WriteFile(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.Write(text);
  file.Commit();
}

}  // namespace

ComparisonFolder::ComparisonFolder(const fs::path& path, const std::string& identity)
    : path_(CheckedFolder(path)), lock_(path, "the folder"), journal_(path / kJournal, identity) {}

void ComparisonFolder::WriteResults(const Matrix& matrix) const {
  WriteFile(path_ / "results.csv", ResultsCsv(matrix));
  WriteFile(path_ / "results.json", MatrixAsJson(matrix) + "\n");
  WriteFile(path_ / "results.md", MatrixAsMarkdown(matrix));
  OutputFile episodes(path_ / "episodes.csv");
  WriteEpisodesCsv(matrix, episodes);
  episodes.Commit();
}

void ComparisonFolder::DrawFigures(const std::stop_token& stop) const {
  const fs::path log = path_ / "figures.log";
  std::error_code error;
  fs::remove(log, error);  // of an earlier call
  const std::string reason = RunFigures(path_, log, stop);
  if (!reason.empty()) {
    throw InputError(fmt::format("the figures could not be drawn: {}; the results stand in {}",
                                 reason, path_.string()));
  }
  fs::remove(log, error);
}

}  // namespace ronda
