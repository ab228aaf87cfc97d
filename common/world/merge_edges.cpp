#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "common/world/map_formats.h"

namespace ronda {
namespace {

constexpr double kCoincidentLengthM =
    0.001;  // a zero-length edge would be a visit that takes no time

}  // namespace

std::vector<Edge> MergeEdges(const GraphData& data, std::vector<Edge> edges, bool both_ways,
                             const std::string& file_name, std::vector<std::string>& warnings) {
  for (Edge& edge : edges) {
    if (edge.source > edge.target) std::swap(edge.source, edge.target);
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.source, a.target, a.length_m) < std::tie(b.source, b.target, b.length_m);
  });
  std::vector<Edge> merged;
  for (Edge edge : edges) {
    const std::string ends =
        fmt::format("{} – {}", data.vertex_ids[edge.source], data.vertex_ids[edge.target]);
    if (!merged.empty() && merged.back().source == edge.source &&
        merged.back().target == edge.target) {
      if (!both_ways || (edge.length_m != merged.back().length_m && edge.length_m != 0.0)) {
        warnings.push_back(
            fmt::format("{}: edge {} has parallel ones of {} m and {} m; the shorter is kept",
                        file_name, ends, merged.back().length_m, edge.length_m));
      }
      continue;
    }
    if (edge.length_m == 0.0) {
      warnings.push_back(
          fmt::format("{}: edge {}: its ends stand on one point; it gets 1 mm", file_name, ends));
      edge.length_m = kCoincidentLengthM;
    }
    merged.push_back(edge);
  }
  return merged;
}

}  // namespace ronda
