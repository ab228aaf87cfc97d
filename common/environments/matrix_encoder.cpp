#include "common/environments/matrix_encoder.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr double kFloor = 1e-6;

}  // namespace

void WriteAffiliation(const PatrolWorld& world, int robot, std::span<float> row) {
  std::fill(row.begin(), row.end(), 0.0f);
  const int ahead = world.target(robot);
  const int behind = world.previous_vertex(robot);
  const double left_m = (world.arrival_s(robot) - world.time_s()) * world.speed_mps(robot);
  float left = 0.0f;  // as a share of the edge
  if (behind >= 0 && left_m > 0.0) {
    const double length_m = world.graph().edge_length_m(behind, ahead);
    left = static_cast<float>(std::min(1.0, left_m / length_m));
    row[behind] = left;
  }
  row[ahead] = 1.0f - left;
}

MatrixEncoder::MatrixEncoder(const PatrolGraph& graph, int robots)
    : graph_(&graph),
      robots_(robots),
      idleness_(IdlenessScale::kRelative, 0.0, graph.vertex_count()) {}

void MatrixEncoder::Encode(const PatrolWorld& world, int robot, std::span<float> observation,
                           std::span<std::uint8_t> legal_actions) {
  RONDA_CHECK(world.robot_count() == robots_, "{} robots for an observation of {}",
              world.robot_count(), robots_);
  RONDA_CHECK(static_cast<int>(observation.size()) == observation_size() &&
                  static_cast<int>(legal_actions.size()) == num_actions(),
              "{} floats and {} actions for an observation of {} and {}", observation.size(),
              legal_actions.size(), observation_size(), num_actions());
  const std::size_t vertices = legal_actions.size();
  WriteAffiliation(world, robot, observation.first(vertices));
  std::size_t row = 1;
  for (int other = 0; other < robots_; ++other) {
    if (other == robot) continue;
    WriteAffiliation(world, other, observation.subspan(row++ * vertices, vertices));
  }
  const double floor_s = kFloor * graph_->mean_edge_length_m() / world.speed_mps(robot);
  const auto idleness = idleness_.Observe(world, floor_s);
  std::copy(idleness.begin(), idleness.end(), observation.last(vertices).begin());
  std::fill(legal_actions.begin(), legal_actions.end(), std::uint8_t{0});
  for (const int next : graph_->neighbours(world.target(robot))) legal_actions[next] = 1;
}

}  // namespace ronda
