#include "deploy/new_file.h"

#include <fmt/format.h>

#include <system_error>

#include "common/base/error.h"

namespace ronda {

void CheckMayWrite(const std::filesystem::path& file, bool force) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw UsageError(fmt::format("{}: is a folder; name the file to write", file.string()));
  if (!force && std::filesystem::exists(std::filesystem::symlink_status(file, ignored)))
    throw UsageError(fmt::format("{}: is there already; --force replaces it", file.string()));
}

}  // namespace ronda
