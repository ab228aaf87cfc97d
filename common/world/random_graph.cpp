#include "common/world/random_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/polygon/voronoi.hpp>
#include <charconv>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/rng.h"

namespace ronda {
namespace {

constexpr std::uint32_t kSide = 1u << 20;  // of the square, in steps of the grid

using Point = boost::polygon::point_data<std::int32_t>;

struct Candidate {
  int source = 0;  // < target
  int target = 0;
  std::int64_t squared_length = 0;
};

std::int64_t SquaredDistance(const Point& a, const Point& b) {
  const std::int64_t dx = std::int64_t{a.x()} - b.x();
  const std::int64_t dy = std::int64_t{a.y()} - b.y();
  return dx * dx + dy * dy;
}

/// The circles that accepted points forbid cover at most π/4 of the square, so this ends.
std::vector<Point> SpreadPoints(int count, Rng& rng) {
  const std::int64_t least = std::int64_t{kSide} * kSide / (4 * std::int64_t{count});
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    const auto x = static_cast<std::int32_t>(rng.Below(kSide));
    const auto y = static_cast<std::int32_t>(rng.Below(kSide));
    const Point point(x, y);
    if (std::ranges::all_of(
            points, [&](const Point& other) { return SquaredDistance(point, other) >= least; })) {
      points.push_back(point);
    }
  }
  return points;
}

/// `c` lies in the closed disc whose diameter is from `a` to `b`.
bool InDisc(const Point& c, const Point& a, const Point& b) {
  return SquaredDistance(a, c) + SquaredDistance(b, c) <= SquaredDistance(a, b);
}

/// Pairs whose closed disc holds no other point, by ascending length. They are among the Delaunay
/// edges, and if any point is in the disc of one, an apex of its two triangles is.
std::vector<Candidate> GabrielEdges(const std::vector<Point>& points) {
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  const auto beyond = [](const auto& edge) {
    return static_cast<int>(edge.twin()->cell()->source_index());
  };
  std::vector<Candidate> found;
  for (const auto& edge : diagram.edges()) {
    const int source = static_cast<int>(edge.cell()->source_index());
    const int target = beyond(edge);
    const auto blocked_by = [&](int apex) {
      return apex != target && InDisc(points[apex], points[source], points[target]);
    };
    if (source > target || blocked_by(beyond(*edge.next())) || blocked_by(beyond(*edge.prev()))) {
      continue;
    }
    found.push_back({source, target, SquaredDistance(points[source], points[target])});
  }
  std::ranges::sort(found, {}, [](const Candidate& edge) {
    return std::tuple(edge.squared_length, edge.source, edge.target);
  });
  return found;
}

/// Kruskal's tree, then others in random order.
std::vector<Candidate> ChooseEdges(const std::vector<Candidate>& candidates, int vertices,
                                   double degree, Rng& rng) {
  boost::disjoint_sets_with_storage<> parts(vertices);
  std::vector<Candidate> chosen;
  std::vector<Candidate> others;
  for (const Candidate& edge : candidates) {
    const auto source = parts.find_set(edge.source);
    const auto target = parts.find_set(edge.target);
    (source == target ? others : chosen).push_back(edge);
    if (source != target) parts.link(source, target);
  }
  const auto wanted = static_cast<std::size_t>(std::lround(vertices * degree / 2.0));
  while (chosen.size() < wanted && !others.empty()) {
    std::swap(others[rng.Below(static_cast<std::uint32_t>(others.size()))], others.back());
    chosen.push_back(others.back());
    others.pop_back();
  }
  std::ranges::sort(chosen, {},
                    [](const Candidate& edge) { return std::pair(edge.source, edge.target); });
  return chosen;
}

void CheckRange(const char* what, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw InputError(
      fmt::format("a random map: {} must be in {} … {}, got {}", what, low, high, value));
}

}  // namespace

PatrolGraph RandomGeometricGraph(const RandomGraphOptions& options) {
  CheckRange("the number of vertices", options.vertices, 2, PatrolGraph::kMaxVertices);
  CheckRange("the mean degree", options.degree, 2, 4);
  CheckRange("the mean edge in metres", options.mean_edge_m, 0.01, 1e6);
  Rng rng = SplitSeed(options.seed, 0);
  const std::vector<Point> points = SpreadPoints(options.vertices, rng);
  const std::vector<Candidate> chosen =
      ChooseEdges(GabrielEdges(points), options.vertices, options.degree, rng);

  double sum = 0.0;
  for (const Candidate& edge : chosen) sum += std::sqrt(static_cast<double>(edge.squared_length));
  const double step_m = options.mean_edge_m * static_cast<double>(chosen.size()) / sum;
  GraphData data;
  data.name = options.name.empty() ? fmt::format("random:{}:{}", options.vertices, options.seed)
                                   : options.name;
  data.source = fmt::format("random: {} vertices, seed {}, mean degree {}, mean edge {} m",
                            options.vertices, options.seed, options.degree, options.mean_edge_m);
  for (int vertex = 0; vertex < options.vertices; ++vertex) {
    data.vertex_ids.push_back(std::to_string(vertex));
    data.positions.push_back({points[vertex].x() * step_m, points[vertex].y() * step_m});
  }
  for (const auto& [source, target, squared_length] : chosen) {
    data.edges.push_back(
        {source, target, Distance_m(data.positions[source], data.positions[target])});
  }
  return PatrolGraph(std::move(data));
}

std::optional<RandomGraphOptions> ParseRandomMap(const std::string& name) {
  constexpr std::string_view kPrefix = "random:";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  RandomGraphOptions options;
  const char* const end = name.data() + name.size();
  const auto [colon, vertices_error] =
      std::from_chars(name.data() + kPrefix.size(), end, options.vertices);
  if (vertices_error == std::errc() && colon != end && *colon == ':') {
    const auto [rest, seed_error] = std::from_chars(colon + 1, end, options.seed);
    if (seed_error == std::errc() && rest == end) return options;
  }
  throw InputError(fmt::format(
      "a random map must be named random:VERTICES:SEED, such as random:40:7, got '{}'", name));
}

}  // namespace ronda
