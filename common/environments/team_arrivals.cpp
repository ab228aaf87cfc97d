#include "common/environments/team_arrivals.h"

#include <algorithm>
#include <limits>

namespace ronda {

DistanceTable::DistanceTable(const ShortestPaths& paths, double unit_m)
    : unit_m_(unit_m),
      stride_((static_cast<std::size_t>(paths.vertex_count()) + 7) / 8 * 8),
      distances_(static_cast<std::size_t>(paths.vertex_count()) * stride_) {
  for (int from = 0; from < paths.vertex_count(); ++from) {
    for (int to = 0; to < paths.vertex_count(); ++to) {
      distances_[offset(from) + to] = static_cast<float>(paths.distance_m(from, to) / unit_m);
    }
  }
}

TeamArrivals::TeamArrivals(const DistanceTable* distances)
    : distances_(distances), earliest_(distances->stride()) {}

void TeamArrivals::Observe(const Belief& belief) {
  const double speed_mps = belief.speeds_mps[belief.robot];
  const double units_per_s = speed_mps / distances_->unit_m();
  others_.clear();
  std::fill(earliest_.begin(), earliest_.end(), std::numeric_limits<float>::infinity());
  float* const earliest = earliest_.data();
  const std::size_t stride = distances_->stride();
  for (int k = 0; k < belief.robot_count(); ++k) {
    if (k == belief.robot || belief.target(k) < 0) continue;
    const OtherRobot other{
        .target = belief.target(k),
        .remaining = static_cast<float>((belief.arrival_s(k) - belief.time_s) * units_per_s),
        .pace = static_cast<float>(speed_mps / belief.speeds_mps[k])};
    others_.push_back(other);
    const float* const distances = distances_->row(other.target);
#pragma omp simd
    for (std::size_t x = 0; x < stride; ++x) {
      const float until = other.remaining + distances[x] * other.pace;
      earliest[x] = until < earliest[x] ? until : earliest[x];
    }
  }
}

}  // namespace ronda
