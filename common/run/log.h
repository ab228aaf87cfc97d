#pragma once
// One log a process: lines with time, process name and level on stderr (which a launcher keeps in a
// file). Thread-safe.
#include <fmt/format.h>

#include <string>
#include <utility>

namespace ronda {

enum class LogLevel { kInfo, kWarning, kError };

/// Names the process in its lines; call it once, before the first line.
void StartLog(const std::string& process_name);

void WriteLog(LogLevel level, const std::string& line);

template <class... Args>
void LogInfo(fmt::format_string<Args...> format, Args&&... args) {
  WriteLog(LogLevel::kInfo, fmt::format(format, std::forward<Args>(args)...));
}

template <class... Args>
void LogWarning(fmt::format_string<Args...> format, Args&&... args) {
  WriteLog(LogLevel::kWarning, fmt::format(format, std::forward<Args>(args)...));
}

template <class... Args>
void LogError(fmt::format_string<Args...> format, Args&&... args) {
  WriteLog(LogLevel::kError, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace ronda
