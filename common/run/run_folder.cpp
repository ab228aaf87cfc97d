#include "common/run/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "common/base/error.h"

namespace ronda {
namespace {

[[noreturn]] void Refuse(const std::filesystem::path& path, const std::string& what) {
  throw InputError(fmt::format("{}: {}", path.string(), what));
}

void MakeFolder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) Refuse(path, "the folder cannot be made: " + error.message());
}

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& path) : path_(path) {
  MakeFolder(path_);
  const auto lock_file = path_ / "lock";
  lock_ = open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock_ < 0) Refuse(path_, fmt::format("the folder cannot be written: {}", strerror(errno)));
  char holder[32] = {};
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    (void)!read(lock_, holder, sizeof holder - 1);
    close(lock_);
    throw Error(ExitCode::kRunFolderInUse,
                fmt::format("{}: this run folder is in use by process {}", path_.string(), holder));
  }
  const std::string pid = std::to_string(getpid());
  if (ftruncate(lock_, 0) != 0 || write(lock_, pid.data(), pid.size()) < 0) {
    const int reason = errno;
    close(lock_);
    Refuse(path_, fmt::format("the folder cannot be written: {}", strerror(reason)));
  }
  MakeFolder(logs());
  MakeFolder(checkpoints());
}

RunFolder::~RunFolder() { close(lock_); }

std::filesystem::path RunFolder::DefaultPath(const std::string& map_name, std::time_t now) {
  std::tm local{};
  localtime_r(&now, &local);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &local);
  const std::string stem =
      fmt::format("{}-{}", std::filesystem::path(map_name).stem().string(), stamp);
  std::filesystem::path path = std::filesystem::path("runs") / stem;
  std::error_code error;
  for (int n = 2; std::filesystem::exists(path, error); ++n) {
    path = std::filesystem::path("runs") / fmt::format("{}-{}", stem, n);
  }
  return path;
}

void WriteWholeFile(const std::filesystem::path& path, const std::string& text) {
  const std::string temporary = fmt::format("{}.{}.tmp", path.string(), getpid());
  const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) Refuse(path, fmt::format("cannot be written: {}", strerror(errno)));
  std::size_t written = 0;
  bool good = true;
  while (good && written < text.size()) {
    const ssize_t count = write(file, text.data() + written, text.size() - written);
    good = count > 0;
    if (good) written += static_cast<std::size_t>(count);
  }
  good = good && fsync(file) == 0;
  int reason = errno;
  close(file);
  if (good && rename(temporary.c_str(), path.c_str()) != 0) {
    reason = errno;
    good = false;
  }
  if (!good) {
    unlink(temporary.c_str());
    Refuse(path, fmt::format("cannot be written: {}", strerror(reason)));
  }
}

}  // namespace ronda
