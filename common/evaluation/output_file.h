#pragma once
// A text file that appears whole or not at all: written beside its place, renamed over it at the
// end.
//
// What stands there already and is no regular file (a pipe, a terminal) is written directly. Throws
// UsageError with path and reason when it cannot be written. Thread-compatible.
#include <filesystem>
#include <fstream>
#include <string_view>

namespace ronda {

class OutputFile {
 public:
  /// Opens at once, so that a bad path shows before any work is done.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();  // without Commit nothing stays
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Write(std::string_view text) {
    stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
  }

  /// Everything is written: gives the file its name.
  void Commit();

 private:
  [[noreturn]] void Refuse() const;

  std::filesystem::path path_;
  std::filesystem::path written_path_;  // equal to path_ where that is written directly
  std::ofstream stream_;
  bool committed_ = false;
};

}  // namespace ronda
