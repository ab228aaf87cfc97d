#include "common/environments/thesis_encoder.h"

#include <algorithm>
#include <numeric>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr float kLargest = 8.0f;
constexpr double kFloor = 1e-6;

double MeanDistance_m(const PatrolGraph& graph, const ShortestPaths& paths) {
  const int vertices = graph.vertex_count();
  if (vertices < 2) return graph.mean_edge_length_m();
  double sum_m = 0.0;
  for (int from = 0; from < vertices; ++from) {
    const double* const row = paths.distances_from(from);
    sum_m += std::accumulate(row, row + vertices, 0.0);
  }
  return sum_m / (static_cast<double>(vertices) * (vertices - 1));
}

}  // namespace

struct ThesisEncoder::Tables {
  Tables(const PatrolGraph& graph, const ShortestPaths& paths)
      : distances(paths, MeanDistance_m(graph, paths)),
        order(static_cast<std::size_t>(graph.vertex_count()) * graph.vertex_count()) {
    for (int from = 0; from < graph.vertex_count(); ++from) {
      const auto row = order.begin() + static_cast<std::ptrdiff_t>(from) * graph.vertex_count();
      std::iota(row, row + graph.vertex_count(), 0);
      std::stable_sort(row, row + graph.vertex_count(), [&](int a, int b) {
        return paths.distance_m(from, a) < paths.distance_m(from, b);
      });
    }
  }

  DistanceTable distances;
  std::vector<int> order;  // (V, V) vertices, nearest first
};

ThesisEncoder::ThesisEncoder(const PatrolGraph& graph, const ShortestPaths& paths,
                             const ThesisBlocks& blocks)
    : graph_(&graph),
      blocks_(blocks),
      tables_(std::make_shared<const Tables>(graph, paths)),
      idleness_(blocks.idleness, blocks.alpha, graph.vertex_count()),
      team_(&tables_->distances) {}

int ThesisEncoder::NextVertex(int vertex, int action) const {
  return tables_->order[static_cast<std::size_t>(vertex) * graph_->vertex_count() + action];
}

void ThesisEncoder::Encode(const Belief& belief, std::span<float> observation,
                           std::span<std::uint8_t> legal_actions) {
  const int vertices = graph_->vertex_count();
  RONDA_CHECK(static_cast<int>(observation.size()) == observation_size() &&
                  static_cast<int>(legal_actions.size()) == num_actions(),
              "{} floats and {} actions for an observation of {} and {}", observation.size(),
              legal_actions.size(), observation_size(), num_actions());
  if (blocks_.others) team_.Observe(belief);
  const int vertex = belief.vertex;
  const double unit_s = tables_->distances.unit_m() / belief.speeds_mps[belief.robot];
  const auto idleness = idleness_.Observe(belief, kFloor * unit_s);
  const auto neighbours = graph_->neighbours(vertex);
  for (int k = 0; k < vertices; ++k) {
    const int x = NextVertex(vertex, k);
    observation[k] = std::min(kLargest, tables_->distances.distance(vertex, x));
    observation[vertices + k] = idleness[x];
    if (blocks_.others) observation[2 * vertices + k] = std::min(kLargest, team_.earliest()[x]);
    legal_actions[k] = std::binary_search(neighbours.begin(), neighbours.end(), x) ? 1 : 0;
  }
  legal_actions[0] = blocks_.stay && belief.stay_s > 0.0 ? 1 : 0;
}

}  // namespace ronda
