#include "common/base/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "common/base/error.h"
#include "common/base/file_descriptor.h"

namespace ronda {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path, const char* what) {
  throw InputError(fmt::format("{}: cannot be {}: {}", path.string(), what, std::strerror(errno)));
}

void WriteAll(const FileDescriptor& file, std::string_view bytes,
              const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) Fail(path, "written");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

std::string ReadWholeFile(const std::filesystem::path& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) Fail(path, "read");
  std::string bytes;
  char block[16384];
  while (true) {
    const ssize_t count = ::read(file.number(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) Fail(path, "read");
    if (count == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(count));
  }
}

void WriteWholeFile(const std::filesystem::path& path, std::string_view bytes, Sync sync) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  try {
    const FileDescriptor file(
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!file.is_open()) Fail(path, "written");
    WriteAll(file, bytes, path);
    if (sync == Sync::kYes && ::fsync(file.number()) != 0) Fail(path, "written");
    if (::rename(temporary.c_str(), path.c_str()) != 0) Fail(path, "written");
  } catch (const InputError&) {
    ::unlink(temporary.c_str());
    throw;
  }
  if (sync == Sync::kNo) return;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.is_open()) ::fsync(directory.number());  // best effort: some file systems refuse
}

std::vector<std::string> LastLines(const std::filesystem::path& path, std::size_t count) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size_bytes = file ? static_cast<std::streamoff>(file.tellg()) : 0;
  const std::streamoff first = std::max<std::streamoff>(0, size_bytes - 65536);
  if (!file.seekg(first)) return {};
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  if (first > 0 && !lines.empty()) lines.erase(lines.begin());  // its beginning is not there
  if (lines.size() > count) lines.erase(lines.begin(), lines.end() - static_cast<long>(count));
  return lines;
}

}  // namespace ronda
