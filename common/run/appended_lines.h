#pragma once
// A text file that only ever grows, by whole lines.
//
// Each line is one write to a file opened for appending, so several processes of one machine may
// share it. A line that an earlier crash cut short is ended first, so it spoils no other. Errors:
// InputError with path, what the lines are and reason. Thread-compatible.
#include <filesystem>
#include <string>

#include "common/base/file_descriptor.h"

namespace ronda {

class AppendedLines {
 public:
  /// Makes the file where it is missing. `what` names the lines in messages: "metrics".
  AppendedLines(const std::filesystem::path& path, const std::string& what);

  /// `line` without its end.
  void Append(const std::string& line);

 private:
  void Write(const std::string& text);
  [[noreturn]] void Fail() const;

  std::filesystem::path path_;
  std::string what_;
  FileDescriptor file_;
};

}  // namespace ronda
