#include "common/world/patrol_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

[[noreturn]] void Refuse(const GraphData& data, const std::string& what) {
  throw InputError(fmt::format("{}: {}", data.name, what));
}

void CheckVertices(const GraphData& data) {
  if (data.positions.size() < 2) {
    Refuse(data, fmt::format("a map has at least 2 vertices, got {}", data.positions.size()));
  }
  RONDA_CHECK(data.vertex_ids.size() == data.positions.size(), "{} ids, {} positions",
              data.vertex_ids.size(), data.positions.size());
  std::unordered_set<std::string> seen;
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    const std::string& id = data.vertex_ids[v];
    if (!seen.insert(id).second) Refuse(data, fmt::format("vertex {} stands twice", id));
    if (!std::isfinite(data.positions[v].x_m) || !std::isfinite(data.positions[v].y_m)) {
      Refuse(data, fmt::format("vertex {}: a position must be finite, got ({}, {})", id,
                               data.positions[v].x_m, data.positions[v].y_m));
    }
  }
  if (!(data.metres_per_px > 0.0) || !std::isfinite(data.metres_per_px)) {
    Refuse(data, fmt::format("metres_per_px must be > 0 and finite, got {}", data.metres_per_px));
  }
}

void CheckEdges(const GraphData& data) {
  const int count = static_cast<int>(data.positions.size());
  std::vector<std::pair<int, int>> seen;
  for (const Edge& edge : data.edges) {
    if (edge.source < 0 || edge.source >= count || edge.target < 0 || edge.target >= count) {
      Refuse(data, fmt::format("an edge joins vertices no. {} and {}, but there are {}",
                               edge.source, edge.target, count));
    }
    const auto name =
        fmt::format("edge {} – {}", data.vertex_ids[edge.source], data.vertex_ids[edge.target]);
    if (edge.source == edge.target) Refuse(data, name + ": joins a vertex to itself");
    if (!(edge.length_m > 0.0) || !std::isfinite(edge.length_m)) {
      Refuse(data, fmt::format("{}: a length must be > 0 and finite, got {}", name, edge.length_m));
    }
    seen.emplace_back(std::minmax(edge.source, edge.target));
  }
  std::sort(seen.begin(), seen.end());
  const auto twice = std::adjacent_find(seen.begin(), seen.end());
  if (twice != seen.end()) {
    Refuse(data, fmt::format("edge {} – {}: stands twice", data.vertex_ids[twice->first],
                             data.vertex_ids[twice->second]));
  }
}

void CheckConnected(const PatrolGraph& graph) {
  std::vector<char> reached(static_cast<std::size_t>(graph.vertex_count()), 0);
  std::vector<int> open{0};
  reached[0] = 1;
  while (!open.empty()) {
    const int vertex = open.back();
    open.pop_back();
    for (const int next : graph.neighbours(vertex)) {
      if (!std::exchange(reached[next], char{1})) open.push_back(next);
    }
  }
  const auto lost = std::find(reached.begin(), reached.end(), 0);
  if (lost != reached.end()) {
    throw InputError(fmt::format(
        "{}: the graph must be connected, but there is no path from vertex {} to vertex {}",
        graph.name(), graph.vertex_id(0),
        graph.vertex_id(static_cast<int>(lost - reached.begin()))));
  }
}

void CheckClosedWalk(const PatrolGraph& graph, const ClosedWalk& walk) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(fmt::format("{}: shortest_closed_walk: {}", graph.name(), what));
  };
  std::vector<char> visited(static_cast<std::size_t>(graph.vertex_count()), 0);
  double length_m = 0.0;
  for (std::size_t i = 0; i < walk.vertices.size(); ++i) {
    const int from = walk.vertices[i];
    const int to = walk.vertices[(i + 1) % walk.vertices.size()];
    const auto neighbours = graph.neighbours(from);
    if (!std::binary_search(neighbours.begin(), neighbours.end(), to)) {
      refuse(fmt::format("goes from {} to {}, which no edge joins", graph.vertex_id(from),
                         graph.vertex_id(to)));
    }
    length_m += graph.edge_length_m(from, to);
    visited[from] = 1;
  }
  const auto missing = std::find(visited.begin(), visited.end(), 0);
  if (missing != visited.end()) {
    refuse(fmt::format("does not visit vertex {}",
                       graph.vertex_id(static_cast<int>(missing - visited.begin()))));
  }
  if (!(std::abs(length_m - walk.length_m) <= 1e-6 * length_m)) {
    refuse(
        fmt::format("length_m must be the sum of its edges, {}, got {}", length_m, walk.length_m));
  }
}

}  // namespace

PatrolGraph::PatrolGraph(GraphData data) : data_(std::move(data)) {
  CheckVertices(data_);
  CheckEdges(data_);
  const auto count = data_.positions.size();
  std::vector<std::vector<std::pair<int, double>>> rows(count);
  for (const Edge& edge : data_.edges) {
    rows[edge.source].emplace_back(edge.target, edge.length_m);
    rows[edge.target].emplace_back(edge.source, edge.length_m);
    mean_edge_length_m_ += edge.length_m / static_cast<double>(data_.edges.size());
  }
  first_arc_.push_back(0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    for (const auto& [neighbour, length_m] : row) {
      neighbours_.push_back(neighbour);
      lengths_m_.push_back(length_m);
    }
    first_arc_.push_back(static_cast<int>(neighbours_.size()));
    max_degree_ = std::max(max_degree_, static_cast<int>(row.size()));
  }
  CheckConnected(*this);
  if (data_.shortest_closed_walk) CheckClosedWalk(*this, *data_.shortest_closed_walk);
}

double PatrolGraph::edge_length_m(int from, int to) const {
  const auto row = neighbours(from);
  const auto found = std::lower_bound(row.begin(), row.end(), to);
  RONDA_CHECK(found != row.end() && *found == to, "vertices {} and {} are no neighbours", from, to);
  return lengths_m(from)[static_cast<std::size_t>(found - row.begin())];
}

}  // namespace ronda
