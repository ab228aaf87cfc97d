#include "common/run/paths.h"

#include <cstdlib>

namespace ronda {

std::filesystem::path HomeFolder() {
  const char* home = std::getenv("RONDA_HOME");
  if (home != nullptr && *home != '\0') return home;
  std::filesystem::path installed = ProgramFolder().parent_path() / "share" / "ronda";
  std::error_code error;
  return std::filesystem::is_directory(installed, error) ? installed : RONDA_SOURCE_DIR;
}

std::filesystem::path MapsFolder() { return HomeFolder() / "maps"; }

std::filesystem::path PoliciesFolder() { return HomeFolder() / "policies"; }

std::filesystem::path ProgramFolder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

}  // namespace ronda
