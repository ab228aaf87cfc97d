#include "common/world/graph_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "common/base/error.h"
#include "common/world/map_formats.h"

namespace ronda {
namespace {

std::string ReadAll(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder, not a map file", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be opened for reading", path.string()));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string ShippedNames(const std::filesystem::path& maps_dir) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(maps_dir, error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

PatrolGraph ReadGraphFile(const std::filesystem::path& path, EdgeLengthSource length_source,
                          std::vector<std::string>* warnings) {
  const std::string text = ReadAll(path);
  const std::string name = path.filename().string();
  std::vector<std::string> ignored;
  auto& notes = warnings != nullptr ? *warnings : ignored;
  if (path.extension() == ".graph") {
    return PatrolGraph(ParsePatrolSimGraph(text, name, length_source, notes));
  }
  if (path.extension() == ".json") {
    return PatrolGraph(ParseNodeLinkGraph(text, name, length_source, notes));
  }
  throw InputError(fmt::format("{}: a map file ends in .graph or .json, got '{}'", path.string(),
                               path.extension().string()));
}

PatrolGraph LoadMap(const std::string& name_or_path, const std::filesystem::path& maps_dir,
                    EdgeLengthSource length_source, std::vector<std::string>* warnings) {
  std::error_code error;
  const bool names_a_file = name_or_path.find('/') != std::string::npos ||
                            std::filesystem::path(name_or_path).has_extension();
  if (names_a_file || std::filesystem::is_regular_file(name_or_path, error)) {
    return ReadGraphFile(name_or_path, length_source, warnings);
  }
  const auto shipped = maps_dir / (name_or_path + ".json");
  if (!name_or_path.empty() && std::filesystem::is_regular_file(shipped, error)) {
    return ReadGraphFile(shipped, length_source, warnings);
  }
  throw InputError(
      fmt::format("no map is called '{}', and no file has that name; maps that ship: {}",
                  name_or_path, ShippedNames(maps_dir)));
}

}  // namespace ronda
