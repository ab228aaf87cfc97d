#pragma once
// A run's folder: runs/NAME/{config.toml, logs/, checkpoints/, metrics.jsonl, summary.json}.
//
// Held by one launcher at a time: a second one gets Error(kRunFolderInUse) that names the holder's
// process id. A folder that cannot be made or written is InputError with the reason. The lock ends
// with the process, whatever ends it.
#include <ctime>
#include <filesystem>
#include <string>

namespace ronda {

class RunFolder {
 public:
  /// Makes the folder and what belongs in it where missing, and takes the lock.
  explicit RunFolder(const std::filesystem::path& path);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path config_file() const { return path_ / "config.toml"; }
  std::filesystem::path logs() const { return path_ / "logs"; }
  std::filesystem::path checkpoints() const { return path_ / "checkpoints"; }
  std::filesystem::path metrics_file() const { return path_ / "metrics.jsonl"; }
  std::filesystem::path summary_file() const { return path_ / "summary.json"; }

  /// runs/<map>-<YYYYmmdd-HHMMSS>, with -2, -3, … where that is taken.
  static std::filesystem::path DefaultPath(const std::string& map_name, std::time_t now);

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

/// Replaces a file as a whole: temporary name beside it, fsync, rename. InputError with the reason
/// on failure.
void WriteWholeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace ronda
