#include "common/world/graph_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "common/base/error.h"
#include "common/world/dot_graph_file.h"
#include "common/world/node_link_file.h"
#include "common/world/random_graph.h"

namespace ronda {
namespace {

namespace fs = std::filesystem;

std::string ReadText(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = 16u << 20;  // JSON takes up to 80 times as much in memory
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw InputError(fmt::format("{}: a map must be a file that can be read, got {}", path.string(),
                                 fs::exists(path, error) ? "something else" : "nothing there"));
  }
  const std::uintmax_t size_bytes = fs::file_size(path, error);
  if (!error && size_bytes > kMaxBytes) {
    throw InputError(fmt::format("{}: a map file must be at most {} bytes, got {}", path.string(),
                                 kMaxBytes, size_bytes));
  }
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw InputError(fmt::format("{}: cannot be read", path.string()));
  return text;
}

}  // namespace

std::vector<std::string> ShippedMaps(const fs::path& maps_dir) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(maps_dir, error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

EdgeLengthSource ParseEdgeLengthSource(const std::string& name) {
  if (name == "euclidean") return EdgeLengthSource::kEuclidean;
  if (name == "file") return EdgeLengthSource::kFile;
  throw InputError(fmt::format("edge lengths are 'euclidean' or from 'file', got '{}'", name));
}

PatrolGraph ReadGraphFile(const fs::path& path, EdgeLengthSource length_source,
                          std::vector<std::string>* warnings) {
  return ParseGraphFile(ReadText(path), path, length_source, warnings);
}

PatrolGraph ParseGraphFile(std::string_view text, const fs::path& path,
                           EdgeLengthSource length_source, std::vector<std::string>* warnings) {
  const std::string extension = path.extension().string();
  if (extension != ".graph" && extension != ".json") {
    throw InputError(fmt::format("{}: the name of a map file must end in .graph or .json, got '{}'",
                                 path.string(), extension));
  }
  const auto parse = extension == ".graph" ? ParseDotGraph : ParseNodeLink;
  std::vector<std::string> found;
  GraphData data = parse(text, path.string(), length_source, found);
  if (data.name.empty()) data.name = path.stem().string();
  try {
    PatrolGraph graph(std::move(data));
    if (warnings != nullptr) warnings->insert(warnings->end(), found.begin(), found.end());
    return graph;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

std::optional<fs::path> FindMapFile(const std::string& name_or_path, const fs::path& maps_dir) {
  if (ParseRandomMap(name_or_path)) return std::nullopt;
  const fs::path path(name_or_path);
  if (path.has_parent_path() || path.extension() == ".graph" || path.extension() == ".json") {
    return path;
  }
  const std::vector<std::string> shipped = ShippedMaps(maps_dir);
  if (std::find(shipped.begin(), shipped.end(), name_or_path) == shipped.end()) {
    throw InputError(
        fmt::format("a map must be a .graph or .json file, random:VERTICES:SEED or one of the maps "
                    "in {} ({}), got '{}'",
                    maps_dir.string(), fmt::join(shipped, ", "), name_or_path));
  }
  return maps_dir / (name_or_path + ".json");
}

PatrolGraph LoadMap(const std::string& name_or_path, const fs::path& maps_dir,
                    EdgeLengthSource length_source, std::vector<std::string>* warnings) {
  const std::optional<fs::path> file = FindMapFile(name_or_path, maps_dir);
  if (!file) return RandomGeometricGraph(*ParseRandomMap(name_or_path));
  return ReadGraphFile(*file, length_source, warnings);
}

}  // namespace ronda
