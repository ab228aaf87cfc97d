#include "deploy/wanted_actors.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/run/run_config.h"

namespace ronda {
namespace {

std::filesystem::path File(const std::filesystem::path& run_folder) {
  return run_folder / "actors";
}

}  // namespace

void WriteWantedActors(const std::filesystem::path& run_folder, int actors) {
  WriteWholeFile(File(run_folder), fmt::format("{}\n", actors));
}

int ReadWantedActors(const std::filesystem::path& run_folder) {
  std::string text = ReadWholeFile(File(run_folder));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  int actors = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), actors);
  if (error != std::errc() || end != text.data() + text.size() || actors < 1 ||
      actors > kMaxActors) {
    throw InputError(fmt::format("{}: must be a whole number from 1 to {}, got '{}'",
                                 File(run_folder).string(), kMaxActors, text));
  }
  return actors;
}

}  // namespace ronda
