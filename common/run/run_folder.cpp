#include "common/run/run_folder.h"

#include <fmt/format.h>

namespace ronda {
namespace {

constexpr const char* kKind = "the run folder";

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& path) : path_(path), lock_(path, kKind) {
  MakeWritableFolder(logs(), kKind);
  MakeWritableFolder(checkpoints(), kKind);
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
