#include "common/world/patrol_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

void CheckVertices(const GraphData& data) {
  const std::size_t count = data.positions.size();
  RONDA_CHECK(data.vertex_ids.size() == count, "{} ids for {} positions", data.vertex_ids.size(),
              count);
  if (count < 2) {
    throw InputError(fmt::format("a graph must have at least 2 vertices, got {}", count));
  }
  if (count > PatrolGraph::kMaxVertices) {
    throw InputError(fmt::format("a graph must have at most {} vertices, got {}",
                                 PatrolGraph::kMaxVertices, count));
  }
  std::unordered_map<std::string, std::size_t> seen;
  for (std::size_t v = 0; v < count; ++v) {
    if (!seen.emplace(data.vertex_ids[v], v).second) {
      throw InputError(fmt::format("vertex ids must differ, got {} twice", data.vertex_ids[v]));
    }
    if (!std::isfinite(data.positions[v].x_m) || !std::isfinite(data.positions[v].y_m)) {
      throw InputError(fmt::format("vertex {}: a position must be finite, got ({}, {})",
                                   data.vertex_ids[v], data.positions[v].x_m,
                                   data.positions[v].y_m));
    }
  }
  if (!std::isfinite(data.metres_per_px) || data.metres_per_px <= 0.0) {
    throw InputError(
        fmt::format("metres_per_px must be positive and finite, got {}", data.metres_per_px));
  }
}

/// Priorities over their mean; alike ones become none.
std::vector<double> Weights(GraphData& data) {
  std::vector<double>& priorities = data.priorities;
  RONDA_CHECK(priorities.empty() || priorities.size() == data.positions.size(),
              "{} priorities for {} vertices", priorities.size(), data.positions.size());
  for (std::size_t v = 0; v < priorities.size(); ++v) {
    if (!IsPriority(priorities[v])) {
      throw InputError(fmt::format("vertex {}: a priority must be in 1e-6 … 1e6, got {}",
                                   data.vertex_ids[v], priorities[v]));
    }
  }
  if (std::ranges::adjacent_find(priorities, std::not_equal_to<>()) == priorities.end()) {
    priorities.clear();
    return std::vector<double>(data.positions.size(), 1.0);
  }
  const double sum = std::accumulate(priorities.begin(), priorities.end(), 0.0);
  std::vector<double> weights;
  for (const double priority : priorities) {
    weights.push_back(priority / sum * static_cast<double>(priorities.size()));
  }
  return weights;
}

void CheckEdges(const GraphData& data) {
  const int count = static_cast<int>(data.positions.size());
  double total_m = 0.0;
  for (std::size_t e = 0; e < data.edges.size(); ++e) {
    const Edge& edge = data.edges[e];
    for (const int end : {edge.source, edge.target}) {
      if (end < 0 || end >= count) {
        throw InputError(fmt::format("edge {}: an end must be one of the vertices 0 to {}, got {}",
                                     e, count - 1, end));
      }
    }
    const auto& source_id = data.vertex_ids[edge.source];
    const auto& target_id = data.vertex_ids[edge.target];
    if (edge.source == edge.target) {
      throw InputError(
          fmt::format("an edge must join two vertices, got a loop at vertex {}", source_id));
    }
    if (!std::isfinite(edge.length_m) || edge.length_m <= 0.0) {
      throw InputError(fmt::format("edge {} - {}: a length must be positive and finite, got {}",
                                   source_id, target_id, edge.length_m));
    }
    total_m += edge.length_m;
  }
  if (!std::isfinite(total_m)) {
    throw InputError("the sum of the edges' lengths must be finite, got inf");
  }
}

void CheckConnected(const PatrolGraph& graph) {
  std::vector<bool> reached(graph.vertex_count(), false);
  std::vector<int> pending{0};
  reached[0] = true;
  while (!pending.empty()) {
    const int vertex = pending.back();
    pending.pop_back();
    for (const int neighbour : graph.neighbours(vertex)) {
      if (!reached[neighbour]) {
        reached[neighbour] = true;
        pending.push_back(neighbour);
      }
    }
  }
  const auto unreached = std::find(reached.begin(), reached.end(), false);
  if (unreached != reached.end()) {
    throw InputError(fmt::format("a graph must be connected, got no path from vertex {} to {}",
                                 graph.vertex_id(0),
                                 graph.vertex_id(static_cast<int>(unreached - reached.begin()))));
  }
}

void CheckClosedWalk(const PatrolGraph& graph, const ClosedWalk& walk) {
  constexpr double kTolerance = 1e-6;  // relative: a file may round the length
  std::vector<bool> visited(graph.vertex_count(), false);
  double length_m = 0.0;
  for (std::size_t k = 0; k < walk.vertices.size(); ++k) {
    const int from = walk.vertices[k];
    const int to = walk.vertices[(k + 1) % walk.vertices.size()];
    const auto row = graph.neighbours(from);
    if (!std::binary_search(row.begin(), row.end(), to)) {
      throw InputError(fmt::format(
          "shortest_closed_walk.vertices[{}]: an edge must join each vertex to the next, "
          "got none from {} to {}",
          k, graph.vertex_id(from), graph.vertex_id(to)));
    }
    visited[from] = true;
    length_m += graph.edge_length_m(from, to);
  }
  const auto missed = std::find(visited.begin(), visited.end(), false);
  if (missed != visited.end()) {
    throw InputError(fmt::format(
        "shortest_closed_walk.vertices: the walk must visit every vertex, but misses {}",
        graph.vertex_id(static_cast<int>(missed - visited.begin()))));
  }
  if (!(std::abs(walk.length_m / length_m - 1.0) <= kTolerance)) {  // length_m may be infinite
    throw InputError(
        fmt::format("shortest_closed_walk.length_m: the walk's edges sum to {} m, got {}", length_m,
                    walk.length_m));
  }
}

}  // namespace

PatrolGraph::PatrolGraph(GraphData data) : data_(std::move(data)) {
  CheckVertices(data_);
  CheckEdges(data_);
  weights_ = Weights(data_);
  const int count = vertex_count();
  std::vector<std::vector<std::pair<int, double>>> rows(count);
  double total_m = 0.0;
  for (const Edge& edge : data_.edges) {
    rows[edge.source].emplace_back(edge.target, edge.length_m);
    rows[edge.target].emplace_back(edge.source, edge.length_m);
    total_m += edge.length_m;
  }
  first_arc_.reserve(count + 1);
  first_arc_.push_back(0);
  for (int v = 0; v < count; ++v) {
    std::sort(rows[v].begin(), rows[v].end());
    for (const auto& [neighbour, length_m] : rows[v]) {
      if (static_cast<int>(neighbours_.size()) > first_arc_[v] && neighbours_.back() == neighbour) {
        throw InputError(fmt::format("an edge must stand once, got {} - {} twice", vertex_id(v),
                                     vertex_id(neighbour)));
      }
      neighbours_.push_back(neighbour);
      lengths_m_.push_back(length_m);
    }
    first_arc_.push_back(static_cast<int>(neighbours_.size()));
    max_degree_ = std::max(max_degree_, degree(v));
  }
  CheckConnected(*this);
  mean_edge_length_m_ = total_m / edge_count();
  if (data_.shortest_closed_walk) {
    CheckClosedWalk(*this, *data_.shortest_closed_walk);
  }
}

double PatrolGraph::edge_length_m(int from, int to) const {
  const auto row = neighbours(from);
  const auto found = std::lower_bound(row.begin(), row.end(), to);
  RONDA_CHECK(found != row.end() && *found == to, "no edge joins vertices {} and {}", from, to);
  return lengths_m(from)[found - row.begin()];
}

}  // namespace ronda
