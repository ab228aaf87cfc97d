#include "common/run/log.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "common/base/error.h"

namespace ronda {
namespace {

std::shared_ptr<spdlog::logger> MakeLogger(const std::string& name, spdlog::sink_ptr sink) {
  auto logger = std::make_shared<spdlog::logger>(name, std::move(sink));
  logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %n %l: %v");
  logger->flush_on(spdlog::level::info);
  return logger;
}

/// The one thing that is the process's own: where its lines go.
std::shared_ptr<spdlog::logger>& ProcessLogger() {
  static std::shared_ptr<spdlog::logger> logger =
      MakeLogger("ronda", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  return logger;
}

spdlog::level::level_enum SpdlogLevel(LogLevel level) {
  switch (level) {
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kWarning:
      return spdlog::level::warn;
    case LogLevel::kError:
      return spdlog::level::err;
  }
  return spdlog::level::err;
}

}  // namespace

void StartLog(const std::string& process_name, const std::optional<std::filesystem::path>& file) {
  if (!file) {
    ProcessLogger() = MakeLogger(process_name, std::make_shared<spdlog::sinks::stderr_sink_mt>());
    return;
  }
  try {
    ProcessLogger() = MakeLogger(
        process_name, std::make_shared<spdlog::sinks::basic_file_sink_mt>(file->string()));
  } catch (const spdlog::spdlog_ex& error) {
    throw InputError(file->string() + ": the log cannot be written: " + error.what());
  }
}

void WriteLog(LogLevel level, fmt::string_view format, fmt::format_args values) {
  const std::string line = fmt::vformat(format, values);
  ProcessLogger()->log(SpdlogLevel(level), spdlog::string_view_t(line));
}

}  // namespace ronda
