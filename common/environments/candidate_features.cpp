#include "common/environments/candidate_features.h"

#include <algorithm>
#include <cmath>

namespace ronda {
namespace {

constexpr float kNever = 1e30f;  // another robot's time where there is no other robot
constexpr float kFloor = 1e-6f;
constexpr float kClip = 8.0f;
constexpr float kKernelScales[] = {1.0f, 3.0f, 9.0f};  // in mean edge lengths

}  // namespace

struct CandidateFeatures::Team {
  int robot;
  int vertex;
  float speed_mps;
  float mean_edge_s;       // ℓ
  float mean_idleness_s;   // m
  float worst_idleness_s;  // max e
  float robots;            // N
};

CandidateFeatures::CandidateFeatures(const PatrolGraph& graph, const ShortestPaths& paths)
    : graph_(graph),
      vertex_count_(graph.vertex_count()),
      mean_edge_m_(static_cast<float>(graph.mean_edge_length_m())) {
  const auto count = static_cast<std::size_t>(vertex_count_);
  distances_m_.resize(count * count);
  kernels_.resize(count * 3 * count);
  for (int v = 0; v < vertex_count_; ++v) {
    for (int x = 0; x < vertex_count_; ++x) {
      distances_m_[v * vertex_count_ + x] = static_cast<float>(paths.distance_m(v, x));
    }
    for (int scale = 0; scale < 3; ++scale) {
      float* row = &kernels_[(v * 3 + scale) * vertex_count_];
      float sum = 0.0f;
      for (int x = 0; x < vertex_count_; ++x) {
        row[x] =
            std::exp(-distances_m_[v * vertex_count_ + x] / (kKernelScales[scale] * mean_edge_m_));
        sum += row[x];
      }
      for (int x = 0; x < vertex_count_; ++x) row[x] /= sum;
    }
  }
  const double tolerance_m = 1e-5 * graph.mean_edge_length_m();
  for (int u = 0; u < vertex_count_; ++u) {
    for (int k = 0; k < graph.degree(u); ++k) {
      const int v = graph.neighbours(u)[k];
      const double w_m = graph.lengths_m(u)[k];
      for (int x = 0; x < vertex_count_; ++x) {
        const bool behind =
            x != u && paths.distance_m(u, x) >= w_m + paths.distance_m(v, x) - tolerance_m;
        behind_.push_back(behind ? 1.0f : 0.0f);
      }
    }
  }
}

void CandidateFeatures::Encode(const PatrolWorld& world, int robot, Scratch& scratch,
                               std::span<float> out) const {
  const int u = world.target(robot);
  const int candidates = graph_.degree(u);
  const auto neighbours = graph_.neighbours(u);
  Team team{.robot = robot,
            .vertex = u,
            .speed_mps = static_cast<float>(world.speed_mps(robot)),
            .mean_edge_s = mean_edge_m_ / static_cast<float>(world.speed_mps(robot)),
            .mean_idleness_s = 0.0f,
            .worst_idleness_s = 0.0f,
            .robots = static_cast<float>(world.robot_count())};
  scratch.idleness_s.resize(static_cast<std::size_t>(vertex_count_));
  scratch.others_s.assign(static_cast<std::size_t>(vertex_count_), kNever);
  scratch.crowding.assign(static_cast<std::size_t>(candidates), 0.0f);
  scratch.behind_sum_s.resize(static_cast<std::size_t>(candidates));
  float sum_s = 0.0f;
  for (int x = 0; x < vertex_count_; ++x) {
    scratch.idleness_s[x] = static_cast<float>(world.idleness_s(x));
    sum_s += scratch.idleness_s[x];
  }
  team.mean_idleness_s = std::max(kFloor, sum_s / static_cast<float>(vertex_count_));
  scratch.idleness_s[u] = 0.0f;
  for (int other = 0; other < world.robot_count(); ++other) {
    if (other == robot) continue;
    const int target = world.target(other);
    const auto wait_s = static_cast<float>(world.arrival_s(other) - world.time_s());
    const float pace = 1.0f / static_cast<float>(world.speed_mps(other));
    const float* from_m = &distances_m_[target * vertex_count_];
    for (int x = 0; x < vertex_count_; ++x) {
      scratch.others_s[x] = std::min(scratch.others_s[x], wait_s + from_m[x] * pace);
    }
    for (int k = 0; k < candidates; ++k) {
      scratch.crowding[k] +=
          std::exp(-(wait_s + from_m[neighbours[k]] * pace) / (2.0f * team.mean_edge_s));
    }
    scratch.idleness_s[target] = 0.0f;
  }
  for (int x = 0; x < vertex_count_; ++x) {
    team.worst_idleness_s = std::max(team.worst_idleness_s, scratch.idleness_s[x]);
  }
  team.worst_idleness_s = std::max(kFloor, team.worst_idleness_s);

  float all_behind_s = 0.0f;
  for (int k = 0; k < candidates; ++k) {
    EncodeCandidate(world, team, k, scratch, &out[static_cast<std::size_t>(k) * kFeatures]);
    all_behind_s += scratch.behind_sum_s[k];
  }
  all_behind_s = std::max(kFloor, all_behind_s);
  for (int k = 0; k < candidates; ++k) {
    float* row = &out[static_cast<std::size_t>(k) * kFeatures];
    row[21] = scratch.behind_sum_s[k] / all_behind_s;
    for (int f = 0; f < kFeatures; ++f) row[f] = std::clamp(row[f], -kClip, kClip);
  }
}

void CandidateFeatures::EncodeCandidate(const PatrolWorld& world, const Team& team, int k,
                                        Scratch& scratch, float* row) const {
  const int v = graph_.neighbours(team.vertex)[k];
  const float edge_s = team.mean_edge_s;
  const float mean_s = team.mean_idleness_s;
  const float pace = 1.0f / team.speed_mps;
  const float way_s = static_cast<float>(graph_.lengths_m(team.vertex)[k]) * pace;  // w

  bool claimed = false;
  double last_visit_s = world.last_visit_s(v);
  const double own_arrival_s = world.time_s() + way_s;
  for (int other = 0; other < world.robot_count(); ++other) {
    if (other == team.robot || world.target(other) != v) continue;
    claimed = true;
    if (world.arrival_s(other) <= own_arrival_s) {
      last_visit_s = std::max(last_visit_s, world.arrival_s(other));
    }
  }

  const float* distance_m = &distances_m_[v * vertex_count_];
  const float* near = &kernels_[(v * 3 + 0) * vertex_count_];
  const float* middle = &kernels_[(v * 3 + 1) * vertex_count_];
  const float* far = &kernels_[(v * 3 + 2) * vertex_count_];
  const float* behind = &behind_[(graph_.first_arc(team.vertex) + k) * vertex_count_];
  float around[3] = {}, around_own[3] = {};
  float best = 0.0f, best_own = 0.0f, sum_own_s = 0.0f, count_own = 0.0f, worst_own_s = 0.0f;
  for (int x = 0; x < vertex_count_; ++x) {
    const float idleness_s = scratch.idleness_s[x];
    const float time_s = way_s + distance_m[x] * pace;
    const float own = time_s < scratch.others_s[x] ? 1.0f : 0.0f;
    const float owned_s = idleness_s * own;
    around[0] += idleness_s * near[x];
    around[1] += idleness_s * middle[x];
    around[2] += idleness_s * far[x];
    around_own[0] += owned_s * near[x];
    around_own[1] += owned_s * middle[x];
    around_own[2] += owned_s * far[x];
    const float worth =
        idleness_s > 0.0f ? behind[x] * (idleness_s + time_s) / (time_s + 0.3f * edge_s) : 0.0f;
    best = std::max(best, worth);
    best_own = std::max(best_own, worth * own);
    count_own += behind[x] * own;
    sum_own_s += behind[x] * owned_s;
    worst_own_s = std::max(worst_own_s, behind[x] * owned_s);
  }
  scratch.behind_sum_s[k] = sum_own_s;

  const auto idleness_s = static_cast<float>(world.idleness_s(v));
  const float on_arrival = static_cast<float>(own_arrival_s - last_visit_s) / mean_s;
  const float lead = std::clamp((scratch.others_s[v] - way_s) / edge_s, -4.0f, 4.0f) / 2.0f;
  const float vertices = static_cast<float>(vertex_count_);
  const bool came_from = world.previous_vertex(team.robot) == v;
  row[0] = way_s / edge_s;
  row[1] = idleness_s / mean_s;
  row[2] = on_arrival;
  row[3] = claimed ? 1.0f : 0.0f;
  row[4] = std::log1p(on_arrival) - std::log(way_s / edge_s + 0.1f);
  row[5] = lead;
  row[6] = scratch.crowding[k];
  row[7] = static_cast<float>(graph_.degree(v)) / 3.0f;
  row[8] = came_from ? 1.0f : 0.0f;
  for (int scale = 0; scale < 3; ++scale) {
    row[9 + scale] = around[scale] / mean_s;
    row[12 + scale] = around_own[scale] / mean_s;
  }
  row[15] = std::log1p(best * edge_s / mean_s);
  row[16] = std::log1p(best_own * edge_s / mean_s);
  row[17] = count_own * team.robots / vertices;
  row[18] = idleness_s / team.worst_idleness_s;
  row[19] = row[3] * lead;
  row[20] = count_own > 0.0f ? sum_own_s / count_own / mean_s : 0.0f;
  row[21] = 0.0f;  // the share of all candidates' sums: known when all are done
  row[22] = 4.0f * team.robots / vertices;
  row[23] = static_cast<float>(graph_.degree(team.vertex)) / 3.0f;
  row[24] = worst_own_s / team.worst_idleness_s;
  row[25] = std::log(mean_s * team.robots / (vertices * edge_s) + 0.001f);
}

}  // namespace ronda
