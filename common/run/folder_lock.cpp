#include "common/run/folder_lock.h"

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

[[noreturn]] void Refuse(const std::filesystem::path& path, const std::string& kind,
                         const std::string& reason) {
  throw InputError(
      fmt::format("{}: {} cannot be made or written: {}", path.string(), kind, reason));
}

[[noreturn]] void RefuseInUse(const std::filesystem::path& path, const std::string& kind,
                              const std::filesystem::path& lock_file) {
  const std::string pid = ReadWholeFile(lock_file);  // empty just after the holder took it
  throw Error(ExitCode::kRunFolderInUse,
              fmt::format("{}: {} is in use by {}", path.string(), kind,
                          pid.empty() ? "another process" : "process " + pid));
}

struct flock WholeFile() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

}  // namespace

void MakeWritableFolder(const std::filesystem::path& path, const std::string& kind) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) Refuse(path, kind, error.message());
  if (::access(path.c_str(), W_OK | X_OK) != 0) Refuse(path, kind, std::strerror(errno));
}

FolderLock::FolderLock(const std::filesystem::path& path, const std::string& kind) {
  MakeWritableFolder(path, kind);
  const std::filesystem::path lock_file = path / "lock";
  lock_ = FileDescriptor(::open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!lock_.is_open()) Refuse(path, kind, std::strerror(errno));
  struct flock whole = WholeFile();
  if (::fcntl(lock_.number(), F_OFD_SETLK, &whole) != 0) {
    if (errno == EAGAIN || errno == EACCES) RefuseInUse(path, kind, lock_file);
    Refuse(path, kind, std::strerror(errno));
  }
  const std::string pid = fmt::format("{}", ::getpid());
  if (::ftruncate(lock_.number(), 0) != 0 ||
      ::write(lock_.number(), pid.data(), pid.size()) != static_cast<ssize_t>(pid.size())) {
    Refuse(path, kind, std::strerror(errno));
  }
}

std::optional<pid_t> FolderLock::Holder(const std::filesystem::path& path) {
  const FileDescriptor file(::open((path / "lock").c_str(), O_RDONLY | O_CLOEXEC));
  struct flock whole = WholeFile();
  if (!file.is_open() || ::fcntl(file.number(), F_OFD_GETLK, &whole) != 0) return std::nullopt;
  if (whole.l_type == F_UNLCK) return std::nullopt;
  const std::string text = ReadWholeFile(path / "lock");
  pid_t pid = 0;  // stays so where the holder has just taken it
  std::from_chars(text.data(), text.data() + text.size(), pid);
  return pid > 0 ? std::optional(pid) : std::nullopt;
}

}  // namespace ronda
