#pragma once
// A folder that one process at a time holds, by an open-file-description lock (fcntl) on its file
// `lock`: the system drops it when the process ends, whatever ends it, children do not inherit it,
// and looking at it disturbs nobody.
//
// Errors: Error(kRunFolderInUse) that names the holder's process id; InputError with the reason
// where the folder cannot be made or written. Thread-compatible.
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include "common/base/file_descriptor.h"

namespace ronda {

/// Makes the folder where it is missing; `kind` names it in messages: "the run folder".
void MakeWritableFolder(const std::filesystem::path& path, const std::string& kind);

class FolderLock {
 public:
  /// Makes the folder where it is missing, and takes it.
  FolderLock(const std::filesystem::path& path, const std::string& kind);

  /// The process that holds the folder; nullopt where nobody does, or there is no such folder.
  static std::optional<pid_t> Holder(const std::filesystem::path& path);

 private:
  FileDescriptor lock_;
};

}  // namespace ronda
