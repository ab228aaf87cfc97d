#include "deploy/map_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <vector>

#include "common/world/closed_walk.h"
#include "common/world/shortest_paths.h"
#include "deploy/terminal_text.h"

namespace ronda {
namespace {

Range RangeOf(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {.least = least, .mean = sum / static_cast<double>(values.size()), .most = most};
}

nlohmann::ordered_json AsJson(const Range& range) {
  return {{"min", range.least}, {"mean", range.mean}, {"max", range.most}};
}

std::string Text(const Range& range) {
  return fmt::format("{:.4g} … {:.4g}, mean {:.4g}", range.least, range.most, range.mean);
}

}  // namespace

MapFacts FactsOf(const PatrolGraph& graph) {
  const ShortestPaths paths(graph);
  const ClosedWalk walk = ClosedWalkOf(graph, paths);
  std::vector<double> degrees, lengths_m, farthest_m, xs_m, ys_m;
  for (const Edge& edge : graph.edges()) lengths_m.push_back(edge.length_m);
  for (int v = 0; v < graph.vertex_count(); ++v) {
    degrees.push_back(graph.degree(v));
    const double* const row_m = paths.distances_from(v);
    farthest_m.push_back(*std::max_element(row_m, row_m + graph.vertex_count()));
    xs_m.push_back(graph.positions()[v].x_m);
    ys_m.push_back(graph.positions()[v].y_m);
  }
  return {.name = graph.name(),
          .source = graph.source(),
          .vertices = graph.vertex_count(),
          .edges = graph.edge_count(),
          .leaves = static_cast<int>(std::ranges::count(degrees, 1.0)),
          .degree = RangeOf(degrees),
          .edge_m = RangeOf(lengths_m),
          .total_m = std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0),
          .diameter_m = std::ranges::max(farthest_m),
          .low = {std::ranges::min(xs_m), std::ranges::min(ys_m)},
          .high = {std::ranges::max(xs_m), std::ranges::max(ys_m)},
          .metres_per_px = graph.metres_per_px(),
          .closed_walk_m = walk.length_m,
          .closed_walk_source = walk.source,
          .priority = graph.unweighted() ? Range{1.0, 1.0, 1.0} : RangeOf(graph.priorities())};
}

std::string FormatSize(const MapFacts& facts) {
  return fmt::format("{:.4g} × {:.4g} m", facts.high.x_m - facts.low.x_m,
                     facts.high.y_m - facts.low.y_m);
}

std::string FormatFacts(const MapFacts& facts) {
  std::string text = Harmless(facts.name) + "\n";
  const auto line = [&text](const char* what, const std::string& value) {
    text += fmt::format("  {:<14}{}\n", what, Harmless(value));
  };
  if (!facts.source.empty()) line("source", facts.source);
  line("vertices", fmt::format("{}, {} of them leaves", facts.vertices, facts.leaves));
  line("edges", fmt::format("{}, {:.6g} m in all", facts.edges, facts.total_m));
  line("degree", Text(facts.degree));
  line("edge length", Text(facts.edge_m) + " m");
  line("diameter", fmt::format("{:.6g} m", facts.diameter_m));
  line("bounding box",
       fmt::format("{}, from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g})", FormatSize(facts),
                   facts.low.x_m, facts.low.y_m, facts.high.x_m, facts.high.y_m));
  line("scale", fmt::format("{} m per px", facts.metres_per_px));
  line("closed walk", fmt::format("{:.6g} m: {}", facts.closed_walk_m, facts.closed_walk_source));
  line("priorities",
       facts.priority.least == facts.priority.most ? "all alike" : Text(facts.priority));
  return text;
}

nlohmann::ordered_json FactsAsJson(const MapFacts& facts) {
  return {{"name", facts.name},
          {"source", facts.source},
          {"vertices", facts.vertices},
          {"edges", facts.edges},
          {"leaves", facts.leaves},
          {"degree", AsJson(facts.degree)},
          {"edge_m", AsJson(facts.edge_m)},
          {"total_m", facts.total_m},
          {"diameter_m", facts.diameter_m},
          {"bounding_box_m",
           {{"min", {facts.low.x_m, facts.low.y_m}}, {"max", {facts.high.x_m, facts.high.y_m}}}},
          {"metres_per_px", facts.metres_per_px},
          {"shortest_closed_walk",
           {{"length_m", facts.closed_walk_m}, {"source", facts.closed_walk_source}}},
          {"priority", AsJson(facts.priority)}};
}

}  // namespace ronda
