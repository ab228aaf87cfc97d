#pragma once
// One log a process: lines `time name level message`, on stderr (which a launcher keeps in a file)
// or in a file of its own.
//
// StartLog is called once, before other threads start; lines before it go to stderr under the name
// `ronda`. The others are thread-safe, and every line is flushed. Errors: InputError where the file
// cannot be written. Cost: one write a line; not for inner loops.
#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace ronda {

enum class LogLevel { kInfo, kWarning, kError };

void StartLog(const std::string& process_name,
              const std::optional<std::filesystem::path>& file = std::nullopt);

void WriteLog(LogLevel level, fmt::string_view format, fmt::format_args values);

template <class... Values>
void LogInfo(fmt::format_string<Values...> format, Values&&... values) {
  WriteLog(LogLevel::kInfo, format, fmt::make_format_args(values...));
}

template <class... Values>
void LogWarning(fmt::format_string<Values...> format, Values&&... values) {
  WriteLog(LogLevel::kWarning, format, fmt::make_format_args(values...));
}

template <class... Values>
void LogError(fmt::format_string<Values...> format, Values&&... values) {
  WriteLog(LogLevel::kError, format, fmt::make_format_args(values...));
}

}  // namespace ronda
