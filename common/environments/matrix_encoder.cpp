#include "common/environments/matrix_encoder.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr double kFloor = 1e-6;

}  // namespace

void WriteAffiliation(const Belief& belief, int robot, std::span<float> row) {
  std::fill(row.begin(), row.end(), 0.0f);
  if (robot == belief.robot) {
    row[belief.vertex] = 1.0f;
    return;
  }
  const int ahead = belief.target(robot);
  if (ahead < 0) return;
  const int behind = belief.previous_vertices[robot];
  const double left_m = (belief.arrival_s(robot) - belief.time_s) * belief.speeds_mps[robot];
  float left = 0.0f;  // as a share of the edge
  if (behind >= 0 && behind != ahead && left_m > 0.0) {
    const double length_m = belief.graph->edge_length_m(behind, ahead);
    left = static_cast<float>(std::min(1.0, left_m / length_m));
    row[behind] = left;
  }
  row[ahead] = 1.0f - left;
}

MatrixEncoder::MatrixEncoder(const PatrolGraph& graph, int robots, bool stay)
    : graph_(&graph),
      robots_(robots),
      stay_(stay),
      idleness_(IdlenessScale::kRelative, 0.0, graph.vertex_count()) {}

void MatrixEncoder::Encode(const Belief& belief, std::span<float> observation,
                           std::span<std::uint8_t> legal_actions) {
  const int robot = belief.robot;
  RONDA_CHECK(belief.robot_count() == robots_, "{} robots for an observation of {}",
              belief.robot_count(), robots_);
  RONDA_CHECK(static_cast<int>(observation.size()) == observation_size() &&
                  static_cast<int>(legal_actions.size()) == num_actions(),
              "{} floats and {} actions for an observation of {} and {}", observation.size(),
              legal_actions.size(), observation_size(), num_actions());
  const std::size_t vertices = legal_actions.size();
  WriteAffiliation(belief, robot, observation.first(vertices));
  std::size_t row = 1;
  for (int other = 0; other < robots_; ++other) {
    if (other == robot) continue;
    WriteAffiliation(belief, other, observation.subspan(row++ * vertices, vertices));
  }
  const double floor_s = kFloor * graph_->mean_edge_length_m() / belief.speeds_mps[robot];
  const auto idleness = idleness_.Observe(belief, floor_s);
  std::copy(idleness.begin(), idleness.end(), observation.last(vertices).begin());
  std::fill(legal_actions.begin(), legal_actions.end(), std::uint8_t{0});
  for (const int next : graph_->neighbours(belief.vertex)) legal_actions[next] = 1;
  if (stay_ && belief.stay_s > 0.0) legal_actions[belief.vertex] = 1;
}

}  // namespace ronda
