#pragma once
// The graph that is patrolled: undirected, connected, vertices with positions, edges with lengths
// in metres.
//
// Vertices are 0 … V − 1 inside the program; `vertex_id` is the name that the map's file uses, and
// the only one that a user sees. Immutable after construction, so any number of threads may read
// it. Neighbours of a vertex stand in one flat array (compressed rows): an *arc* is a position in
// it, so every edge has two arcs. Source: thesis §1.2, §1.3.
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ronda {

struct Position {
  double x_m = 0.0;
  double y_m = 0.0;
};

inline double Distance_m(const Position& a, const Position& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

struct Edge {
  int source = 0;
  int target = 0;
  double length_m = 0.0;  // > 0
};

/// A closed walk through all vertices: the vertices in order, each joined to the next (and the last
/// to the first) by an edge of the graph. `length_m` is its length; `source` says how it was found.
struct ClosedWalk {
  std::vector<int> vertices;
  double length_m = 0.0;
  std::string source;
};

/// What a map file says, before it has become a graph.
struct GraphData {
  std::string name = {};
  std::vector<std::string> vertex_ids = {};  // (V)
  std::vector<Position> positions = {};      // (V)
  std::vector<Edge> edges = {};              // each once, either direction
  std::vector<double> priorities = {};       // (V) only ratios count; empty: all alike
  double metres_per_px = 1.0;                // some strategies are defined in px
  std::string source = {};                   // where the map comes from, for people
  std::optional<ClosedWalk> shortest_closed_walk = {};
};

/// What a vertex's priority may be: in 1e-6 … 1e6.
inline bool IsPriority(double value) { return value >= 1e-6 && value <= 1e6; }

class PatrolGraph {
 public:
  /// Bounds the memory of all-pairs tables (1.2 GB), whatever a file says.
  static constexpr int kMaxVertices = 10000;

  /// Throws InputError when there are fewer than 2 vertices or more than kMaxVertices, when an edge
  /// is not positive and finite (or all together are not), names no vertex, is a loop or stands
  /// twice, when an id stands twice, when a priority is not in 1e-6 … 1e6, when the graph is not
  /// connected, or when the closed walk is none; the message names the element.
  explicit PatrolGraph(GraphData data);

  /// What it was made of.
  const GraphData& data() const { return data_; }
  const std::string& name() const { return data_.name; }
  int vertex_count() const { return static_cast<int>(data_.positions.size()); }
  int edge_count() const { return static_cast<int>(data_.edges.size()); }
  int max_degree() const { return max_degree_; }
  int degree(int vertex) const { return first_arc_[vertex + 1] - first_arc_[vertex]; }
  /// Neighbours of `vertex`, ascending.
  std::span<const int> neighbours(int vertex) const {
    return {neighbours_.data() + first_arc_[vertex], static_cast<std::size_t>(degree(vertex))};
  }
  /// Lengths of the edges to `neighbours(vertex)`, in the same order.
  std::span<const double> lengths_m(int vertex) const {
    return {lengths_m_.data() + first_arc_[vertex], static_cast<std::size_t>(degree(vertex))};
  }
  /// The first arc of `vertex`; its k-th neighbour is arc first_arc(vertex) + k.
  int first_arc(int vertex) const { return first_arc_[vertex]; }
  /// Length of the edge between two neighbours; a bug if there is none.
  double edge_length_m(int from, int to) const;
  double mean_edge_length_m() const { return mean_edge_length_m_; }

  const std::vector<Edge>& edges() const { return data_.edges; }
  const std::vector<Position>& positions() const { return data_.positions; }
  const std::string& vertex_id(int vertex) const { return data_.vertex_ids[vertex]; }
  double metres_per_px() const { return data_.metres_per_px; }
  /// What a second of idleness counts at each vertex: its priority over their mean, 1 where all are
  /// alike.
  std::span<const double> weights() const { return weights_; }
  /// (V) as the map gave them; empty where all are alike.
  const std::vector<double>& priorities() const { return data_.priorities; }
  /// No vertex counts more than another.
  bool unweighted() const { return data_.priorities.empty(); }
  const std::string& source() const { return data_.source; }
  /// The shortest closed walk that came with the map, if one did.
  const std::optional<ClosedWalk>& shortest_closed_walk() const {
    return data_.shortest_closed_walk;
  }

 private:
  GraphData data_;
  std::vector<int> first_arc_;     // (V + 1)
  std::vector<int> neighbours_;    // (2E)
  std::vector<double> lengths_m_;  // (2E)
  std::vector<double> weights_;    // (V) mean 1
  int max_degree_ = 0;
  double mean_edge_length_m_ = 0.0;
};

}  // namespace ronda
