#pragma once
// A run's folder: runs/NAME/{config.toml, logs/, checkpoints/, metrics.jsonl, summary.json}.
//
// Held by one launcher at a time; errors as folder_lock.h. Thread-compatible.
#include <sys/types.h>

#include <ctime>
#include <filesystem>
#include <optional>
#include <string>

#include "common/run/folder_lock.h"

namespace ronda {

class RunFolder {
 public:
  /// Makes the folder and what belongs in it where missing, and takes the lock.
  explicit RunFolder(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path config_file() const { return path_ / "config.toml"; }
  std::filesystem::path logs() const { return path_ / "logs"; }
  std::filesystem::path checkpoints() const { return path_ / "checkpoints"; }
  std::filesystem::path metrics_file() const { return path_ / "metrics.jsonl"; }
  std::filesystem::path summary_file() const { return path_ / "summary.json"; }

  /// The process that holds the folder; nullopt where nobody does, or there is no such folder.
  static std::optional<pid_t> Holder(const std::filesystem::path& path) {
    return FolderLock::Holder(path);
  }

  /// `<map>-<YYYYmmdd-HHMMSS>` in local time; `map` is a name, or a path of which the stem counts.
  static std::string DefaultName(const std::string& map, std::time_t now);

  /// `runs/` and the default name, with -2, -3, … where that is there already.
  static std::filesystem::path DefaultPath(const std::string& map, std::time_t now);

 private:
  std::filesystem::path path_;
  FolderLock lock_;
};

}  // namespace ronda
