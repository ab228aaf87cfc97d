#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/world/graph_file.h"

namespace ronda {
namespace {

/// 15 digits: one less than a double can tell apart, so that 31 does not become 31.000000000000004.
std::string Px(double value_px) {
  if (std::isfinite(value_px)) return fmt::format("{:.15g}", value_px);
  throw InputError("a map with such large or small numbers cannot be written in px");
}

/// y grows to the north, as in the files of patrolling_sim.
const char* CompassWord(const Position& from, const Position& to) {
  constexpr std::array kWords{"E", "NE", "N", "NW", "W", "SW", "S", "SE"};
  const double eighths = std::atan2(to.y_m - from.y_m, to.x_m - from.x_m) / (std::numbers::pi / 4);
  return kWords[(std::lround(eighths) + 8) % 8];
}

struct Extent {
  Position low;  // at most 0, so that no coordinate is negative
  Position high;
};

Extent ExtentOf(const PatrolGraph& graph) {
  Extent extent;
  for (const Position& at : graph.positions()) {
    extent.low = {std::min(extent.low.x_m, at.x_m), std::min(extent.low.y_m, at.y_m)};
    extent.high = {std::max(extent.high.x_m, at.x_m), std::max(extent.high.y_m, at.y_m)};
  }
  return extent;
}

std::string DotGraph(const PatrolGraph& graph) {
  const Extent extent = ExtentOf(graph);
  const double scale_mpp = graph.metres_per_px();
  const auto px = [&](double at_m, double offset_m) { return (at_m - offset_m) / scale_mpp; };
  const auto size_px = [&](double high_m, double low_m) {
    return Px(std::max(0.0, std::ceil(px(high_m, low_m) - 1e-6)));  // rounding adds no pixel
  };
  std::string text = fmt::format(
      "{}\n{}\n{}\n{}\n{}\n{}\n", graph.vertex_count(), size_px(extent.high.x_m, extent.low.x_m),
      size_px(extent.high.y_m, extent.low.y_m), scale_mpp, extent.low.x_m, extent.low.y_m);
  for (int vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    const Position& at = graph.positions()[vertex];
    fmt::format_to(std::back_inserter(text), "\n{}\n{}\n{}\n{}\n", vertex,
                   Px(px(at.x_m, extent.low.x_m)), Px(px(at.y_m, extent.low.y_m)),
                   graph.degree(vertex));
    for (const int neighbour : graph.neighbours(vertex)) {
      fmt::format_to(std::back_inserter(text), "{}\n{}\n{}\n", neighbour,
                     CompassWord(at, graph.positions()[neighbour]),
                     Px(graph.edge_length_m(vertex, neighbour) / scale_mpp));
    }
  }
  return text;
}

/// One sentence for each kind of thing that a `.graph` file cannot say.
std::vector<std::string> Losses(const PatrolGraph& graph, const std::string& name_of_file) {
  std::vector<std::string> losses;
  for (int vertex = 0; vertex < graph.vertex_count(); ++vertex) {
    if (graph.vertex_id(vertex) == std::to_string(vertex)) continue;
    losses.push_back(
        fmt::format("the ids are lost: a .graph file numbers its vertices from 0, so vertex '{}' "
                    "becomes {}",
                    graph.vertex_id(vertex), vertex));
    break;
  }
  for (const Edge& edge : graph.edges()) {
    const double distance_m = std::max(
        Distance_m(graph.positions()[edge.source], graph.positions()[edge.target]), kSamePoint_m);
    if (std::abs(edge.length_m - distance_m) <= 1e-9 * edge.length_m) continue;
    losses.push_back(fmt::format(
        "lengths come back with --length file only: the edge {} - {} is {} m long, its "
        "ends are {:.6g} m apart",
        graph.vertex_id(edge.source), graph.vertex_id(edge.target), edge.length_m, distance_m));
    break;
  }
  if (!graph.unweighted()) losses.push_back("the priorities of the vertices are lost");
  if (const auto& walk = graph.shortest_closed_walk()) {
    losses.push_back(fmt::format("the shortest closed walk of {:.6g} m is lost", walk->length_m));
  }
  if (graph.name() != name_of_file) {
    losses.push_back(fmt::format("the name '{}' is lost: the file's name counts", graph.name()));
  }
  if (!graph.source().empty()) {
    losses.push_back(fmt::format("the source '{}' is lost", graph.source()));
  }
  return losses;
}

}  // namespace

void WriteDotGraph(const PatrolGraph& graph, const std::filesystem::path& path,
                   std::vector<std::string>* warnings) {
  WriteWholeFile(path, DotGraph(graph), Sync::kNo);
  if (warnings == nullptr) return;
  for (const std::string& loss : Losses(graph, path.stem().string())) {
    warnings->push_back(fmt::format("{}: {}", path.string(), loss));
  }
}

}  // namespace ronda
