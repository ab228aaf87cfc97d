#include "common/run/metrics_log.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/base/error.h"

namespace ronda {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path) {
  throw InputError(
      fmt::format("{}: metrics cannot be written: {}", path.string(), std::strerror(errno)));
}

bool EndsWithinLine(const FileDescriptor& file) {
  const off_t size_bytes = ::lseek(file.number(), 0, SEEK_END);
  char last = '\n';
  return size_bytes > 0 && ::pread(file.number(), &last, 1, size_bytes - 1) == 1 && last != '\n';
}

void WriteText(const FileDescriptor& file, const std::string& text,
               const std::filesystem::path& path) {
  ssize_t written = 0;
  do {
    written = ::write(file.number(), text.data(), text.size());
  } while (written < 0 && errno == EINTR);
  if (written != static_cast<ssize_t>(text.size())) Fail(path);
}

}  // namespace

MetricsLog::MetricsLog(const std::filesystem::path& path, const std::string& process_name)
    : path_(path),
      process_name_(process_name),
      file_(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {
  if (!file_.is_open()) Fail(path_);
  if (EndsWithinLine(file_)) WriteText(file_, "\n", path_);
}

void MetricsLog::Append(double time_s, const std::vector<Metric>& metrics) {
  nlohmann::ordered_json line{{"time_s", time_s}, {"process", process_name_}};
  for (const Metric& metric : metrics) {
    std::visit([&](const auto& value) { line[metric.name] = value; }, metric.value);
  }
  WriteText(file_, line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
            path_);
}

}  // namespace ronda
