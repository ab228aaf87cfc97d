#pragma once
// What the tests of graphs share: map files in a folder of their own, random connected graphs, and
// the message of an InputError.
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/rng.h"
#include "common/world/graph_file.h"

namespace ronda::testing {

/// A file that goes with the object.
class MapFile {
 public:
  MapFile(const std::string& name, const std::string& text) {
    std::string pattern = (std::filesystem::temp_directory_path() / "ronda-map-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    path_ = folder_ / name;
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~MapFile() { std::filesystem::remove_all(folder_); }
  MapFile(const MapFile&) = delete;
  MapFile& operator=(const MapFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

/// What reading says, with the folder left out; "no error" if it succeeds.
inline std::string ErrorOf(const std::string& name, const std::string& text,
                           EdgeLengthSource length_source = EdgeLengthSource::kEuclidean) {
  const MapFile file(name, text);
  try {
    ReadGraphFile(file.path(), length_source, nullptr);
  } catch (const InputError& error) {
    const std::string folder = file.path().parent_path().string() + "/";
    const std::string what = error.what();
    return what.starts_with(folder) ? what.substr(folder.size()) : what;
  }
  return "no error";
}

struct ReadResult {
  PatrolGraph graph;
  std::vector<std::string> warnings;  // with the folder left out
};

inline ReadResult ReadText(const std::string& name, const std::string& text,
                           EdgeLengthSource length_source = EdgeLengthSource::kEuclidean) {
  const MapFile file(name, text);
  std::vector<std::string> warnings;
  PatrolGraph graph = ReadGraphFile(file.path(), length_source, &warnings);
  for (std::string& warning : warnings) {
    warning.erase(0, file.path().parent_path().string().size() + 1);
  }
  return {std::move(graph), std::move(warnings)};
}

/// A random tree on points in a 100 m square, with `extra` more edges where they are new.
inline GraphData RandomGraphData(int vertices, int extra, std::uint64_t seed) {
  Rng rng = SplitSeed(seed, 0);
  GraphData data;
  std::set<std::pair<int, int>> joined;
  const auto join = [&](int a, int b) {
    if (a == b || !joined.emplace(std::min(a, b), std::max(a, b)).second) return;
    const Position& from = data.positions[a];
    const Position& to = data.positions[b];
    data.edges.push_back({a, b, std::hypot(from.x_m - to.x_m, from.y_m - to.y_m)});
  };
  for (int v = 0; v < vertices; ++v) {
    data.vertex_ids.push_back(std::to_string(v));
    data.positions.push_back({100.0 * rng.Uniform(), 100.0 * rng.Uniform()});
    if (v > 0) join(static_cast<int>(rng.Below(v)), v);
  }
  for (int k = 0; k < extra; ++k) {
    join(static_cast<int>(rng.Below(vertices)), static_cast<int>(rng.Below(vertices)));
  }
  return data;
}

inline PatrolGraph ShippedMap(const std::string& name) {
  return LoadMap(name, std::string(RONDA_SOURCE_DIR) + "/maps", EdgeLengthSource::kEuclidean,
                 nullptr);
}

}  // namespace ronda::testing
