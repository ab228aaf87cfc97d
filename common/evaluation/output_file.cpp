#include "common/evaluation/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "common/base/error.h"

namespace ronda {

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), written_path_(path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error) || std::filesystem::is_regular_file(path, error)) {
    written_path_ += fmt::format(".{}.partial", getpid());
  }
  errno = 0;
  stream_.open(written_path_, std::ios::binary | std::ios::trunc);
  if (!stream_) Refuse();
}

OutputFile::~OutputFile() {
  if (committed_ || written_path_ == path_) return;
  stream_.close();
  std::error_code error;  // nothing better to do with it
  std::filesystem::remove(written_path_, error);
}

void OutputFile::Commit() {
  errno = 0;
  stream_.close();
  if (!stream_) Refuse();
  if (written_path_ != path_ && std::rename(written_path_.c_str(), path_.c_str()) != 0) Refuse();
  committed_ = true;
}

void OutputFile::Refuse() const {
  const std::string reason = errno != 0 ? std::strerror(errno) : "unknown error";
  throw UsageError(fmt::format("{}: cannot be written: {}", path_.string(), reason));
}

}  // namespace ronda
