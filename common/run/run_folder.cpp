#include "common/run/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

#include "common/base/error.h"
#include "common/base/whole_file.h"

namespace ronda {
namespace {

[[noreturn]] void Refuse(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(
      fmt::format("{}: the run folder cannot be made or written: {}", path.string(), reason));
}

void MakeWritable(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) Refuse(path, error.message());
  if (::access(path.c_str(), W_OK | X_OK) != 0) Refuse(path, std::strerror(errno));
}

[[noreturn]] void RefuseInUse(const std::filesystem::path& path,
                              const std::filesystem::path& lock_file) {
  const std::string pid = ReadWholeFile(lock_file);  // empty just after the holder took it
  throw Error(ExitCode::kRunFolderInUse,
              fmt::format("{}: the run folder is in use by {}", path.string(),
                          pid.empty() ? "another process" : "process " + pid));
}

struct flock WholeFile() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

FileDescriptor Lock(const std::filesystem::path& path) {
  const std::filesystem::path lock_file = path / "lock";
  FileDescriptor lock(::open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!lock.is_open()) Refuse(path, std::strerror(errno));
  struct flock whole = WholeFile();
  if (::fcntl(lock.number(), F_OFD_SETLK, &whole) != 0) {
    if (errno == EAGAIN || errno == EACCES) RefuseInUse(path, lock_file);
    Refuse(path, std::strerror(errno));
  }
  const std::string pid = fmt::format("{}", ::getpid());
  if (::ftruncate(lock.number(), 0) != 0 ||
      ::write(lock.number(), pid.data(), pid.size()) != static_cast<ssize_t>(pid.size())) {
    Refuse(path, std::strerror(errno));
  }
  return lock;
}

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& path) : path_(path) {
  MakeWritable(path_);
  lock_ = Lock(path_);
  MakeWritable(logs());
  MakeWritable(checkpoints());
}

std::optional<pid_t> RunFolder::Holder(const std::filesystem::path& path) {
  const FileDescriptor file(::open((path / "lock").c_str(), O_RDONLY | O_CLOEXEC));
  struct flock whole = WholeFile();
  if (!file.is_open() || ::fcntl(file.number(), F_OFD_GETLK, &whole) != 0) return std::nullopt;
  if (whole.l_type == F_UNLCK) return std::nullopt;
  const std::string text = ReadWholeFile(path / "lock");
  pid_t pid = 0;  // stays so where the holder has just taken it
  std::from_chars(text.data(), text.data() + text.size(), pid);
  return pid > 0 ? std::optional(pid) : std::nullopt;
}

std::string RunFolder::DefaultName(const std::string& map, std::time_t now) {
  std::tm local{};
  ::localtime_r(&now, &local);
  char time[32];
  std::strftime(time, sizeof time, "%Y%m%d-%H%M%S", &local);
  return std::filesystem::path(map).stem().string() + "-" + time;
}

std::filesystem::path RunFolder::DefaultPath(const std::string& map, std::time_t now) {
  const std::filesystem::path first = std::filesystem::path("runs") / DefaultName(map, now);
  std::filesystem::path path = first;
  std::error_code ignored;  // what cannot be looked at is refused when the folder is made
  for (int n = 2; std::filesystem::exists(path, ignored); ++n) {
    path = first.string() + fmt::format("-{}", n);
  }
  return path;
}

}  // namespace ronda
