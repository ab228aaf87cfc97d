#pragma once
// Metrics as JSON lines, append-only: {"time_s":1.5,"process":"learner","loss":0.1}.
//
// Each line is one write to a file opened for appending, so several processes of one machine may
// share it. A line that an earlier crash cut short is ended first, so it spoils no other. A value
// that is not finite is written as null. Errors: InputError with path and reason.
// Thread-compatible.
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "common/base/file_descriptor.h"

namespace ronda {

struct Metric {
  std::string name;  // with its unit last: "update_time_s"
  std::variant<std::int64_t, double, std::string> value;
};

class MetricsLog {
 public:
  MetricsLog(const std::filesystem::path& path, const std::string& process_name);

  /// `time_s`: since the run began.
  void Append(double time_s, const std::vector<Metric>& metrics);

 private:
  std::filesystem::path path_;
  std::string process_name_;
  FileDescriptor file_;
};

}  // namespace ronda
