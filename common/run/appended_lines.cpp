#include "common/run/appended_lines.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "common/base/error.h"

namespace ronda {
namespace {

bool EndsWithinLine(const FileDescriptor& file) {
  const off_t size_bytes = ::lseek(file.number(), 0, SEEK_END);
  char last = '\n';
  return size_bytes > 0 && ::pread(file.number(), &last, 1, size_bytes - 1) == 1 && last != '\n';
}

}  // namespace

AppendedLines::AppendedLines(const std::filesystem::path& path, const std::string& what)
    : path_(path),
      what_(what),
      file_(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {
  if (!file_.is_open()) Fail();
  if (EndsWithinLine(file_)) Write("\n");
}

void AppendedLines::Append(const std::string& line) { Write(line + "\n"); }

void AppendedLines::Write(const std::string& text) {
  ssize_t written = 0;
  do {
    written = ::write(file_.number(), text.data(), text.size());
  } while (written < 0 && errno == EINTR);
  if (written != static_cast<ssize_t>(text.size())) Fail();
}

void AppendedLines::Fail() const {
  throw InputError(
      fmt::format("{}: {} cannot be written: {}", path_.string(), what_, std::strerror(errno)));
}

}  // namespace ronda
