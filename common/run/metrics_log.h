#pragma once
// Metrics as JSON lines, append-only: {"time_s":1.5,"process":"learner","loss":0.1}.
//
// Appended as appended_lines.h says; errors as there. A value that is not finite is written as
// null. Thread-compatible.
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "common/run/appended_lines.h"

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
  std::string process_name_;
  AppendedLines lines_;
};

}  // namespace ronda
