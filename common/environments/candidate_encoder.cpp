#include "common/environments/candidate_encoder.h"

#include <algorithm>
#include <cmath>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr int kKernels = 3;
constexpr std::array<double, kKernels> kKernelReach = {1.0, 3.0, 9.0};
constexpr float kTolerance = 1e-5f;
constexpr float kFloor = 1e-6f;
constexpr float kLargestFeature = 8.0f;
constexpr int kShareOfSum = 21;  // position of "share_of_sum", the one that looks at all candidates

}  // namespace

/// What follows from the graph alone.
struct CandidateEncoder::Tables {
  Tables(const PatrolGraph& graph, const ShortestPaths& paths)
      : distances(paths, graph.mean_edge_length_m()) {
    const int vertices = graph.vertex_count();
    const std::size_t stride = distances.stride();
    for (int j = 0; j < kKernels; ++j) {
      kernels[j].resize(static_cast<std::size_t>(vertices) * stride);
      for (int v = 0; v < vertices; ++v) {
        float* const row = &kernels[j][distances.offset(v)];
        double sum = 0.0;
        for (int x = 0; x < vertices; ++x) {
          sum += std::exp(-distances.distance(v, x) / kKernelReach[j]);
        }
        for (int x = 0; x < vertices; ++x) {
          row[x] = static_cast<float>(std::exp(-distances.distance(v, x) / kKernelReach[j]) / sum);
        }
      }
    }
    behind.resize((2 * static_cast<std::size_t>(graph.edge_count()) + 1) * stride);
    for (int u = 0; u < vertices; ++u) {
      for (int k = 0; k < graph.degree(u); ++k) {
        float* const row = &behind[distances.offset(graph.first_arc(u) + k)];
        const double length_m = graph.lengths_m(u)[k];
        const double* const onward_m = paths.distances_from(graph.neighbours(u)[k]);
        const double slack_m = static_cast<double>(kTolerance) * graph.mean_edge_length_m();
        for (int x = 0; x < vertices; ++x) {
          const bool is_behind = paths.distance_m(u, x) >= length_m + onward_m[x] - slack_m;
          row[x] = x != u && is_behind ? 1.0f : 0.0f;
        }
      }
    }
  }

  DistanceTable distances;
  std::array<std::vector<float>, kKernels> kernels;  // (V, stride) rows sum to 1
  std::vector<float> behind;  // (arcs + 1, stride) 0 or 1; the last row is of staying put
};

/// What one pass over all vertices finds for one candidate.
struct CandidateEncoder::Scan {
  std::array<float, kKernels> around{};      // kernel means of e
  std::array<float, kKernels> own_around{};  // the same over own
  float best = 0.0f;                         // best (e + t) / (t + 0.3) over behind, e > 0
  float best_own = 0.0f;                     // over behind ∩ own
  float count = 0.0f;                        // |behind ∩ own|
  float sum = 0.0f;                          // Σ e over it
  float largest = 0.0f;                      // max e over it
};

CandidateEncoder::CandidateEncoder(const PatrolGraph& graph, const ShortestPaths& paths, bool stay)
    : graph_(&graph),
      stay_(stay),
      tables_(std::make_shared<const Tables>(graph, paths)),
      team_(&tables_->distances),
      idleness_(tables_->distances.stride()),
      worthwhile_(tables_->distances.stride()) {}

void CandidateEncoder::ObserveIdleness(const Belief& belief) {
  const double units_per_s = belief.speeds_mps[belief.robot] / graph_->mean_edge_length_m();
  const int vertices = graph_->vertex_count();
  float sum = 0.0f;
  for (int x = 0; x < vertices; ++x) {
    idleness_[x] = static_cast<float>(belief.idleness_s(x) * units_per_s);
    sum += idleness_[x];
  }
  mean_idleness_ = std::max(kFloor, sum / static_cast<float>(vertices));
  worthwhile_ = idleness_;  // 0 at the robot's vertex, which it has just visited
  for (const OtherRobot& other : team_.others()) worthwhile_[other.target] = 0.0f;
  largest_worthwhile_ = std::max(kFloor, *std::max_element(worthwhile_.begin(), worthwhile_.end()));
}

CandidateEncoder::Scan CandidateEncoder::ScanVertices(int arc, int candidate,
                                                      float distance) const {
  const DistanceTable& distances = tables_->distances;
  const std::size_t stride = distances.stride();
  const std::size_t row = distances.offset(candidate);
  const float* const onward = distances.row(candidate);
  const float* const kernel_1 = &tables_->kernels[0][row];
  const float* const kernel_3 = &tables_->kernels[1][row];
  const float* const kernel_9 = &tables_->kernels[2][row];
  const float* const behind = &tables_->behind[distances.offset(arc)];
  const float* const worthwhile = worthwhile_.data();
  const float* const earliest_other = team_.earliest();
  float near_1 = 0.0f, near_3 = 0.0f, near_9 = 0.0f, own_1 = 0.0f, own_3 = 0.0f, own_9 = 0.0f;
  float best = 0.0f, best_own = 0.0f, count = 0.0f, sum = 0.0f, largest = 0.0f;
#pragma omp simd reduction(+ : near_1, near_3, near_9, own_1, own_3, own_9, count, sum) \
    reduction(max : best, best_own, largest)
  for (std::size_t x = 0; x < stride; ++x) {
    const float until = distance + onward[x];
    const float e = worthwhile[x];
    const float own = until + kTolerance < earliest_other[x] ? 1.0f : 0.0f;
    const float own_e = own * e;
    near_1 += kernel_1[x] * e;
    near_3 += kernel_3[x] * e;
    near_9 += kernel_9[x] * e;
    own_1 += kernel_1[x] * own_e;
    own_3 += kernel_3[x] * own_e;
    own_9 += kernel_9[x] * own_e;
    const float own_behind = own * behind[x];
    const float own_behind_e = own_behind * e;
    count += own_behind;
    sum += own_behind_e;
    largest = own_behind_e > largest ? own_behind_e : largest;
    const float eligible = e > 0.0f ? behind[x] : 0.0f;
    const float rate = eligible * (e + until) / (until + 0.3f);
    const float own_rate = own * rate;
    best = rate > best ? rate : best;
    best_own = own_rate > best_own ? own_rate : best_own;
  }
  return {.around = {near_1, near_3, near_9},
          .own_around = {own_1, own_3, own_9},
          .best = best,
          .best_own = best_own,
          .count = count,
          .sum = sum,
          .largest = largest};
}

void CandidateEncoder::EncodeCandidate(const Belief& belief, int k, int team_size,
                                       float* features) const {
  const int vertex = belief.vertex;
  const int candidate = NextVertex(vertex, k);
  const bool stays = candidate == vertex;
  const DistanceTable& distances = tables_->distances;
  const double length_m =
      stays ? belief.stay_s * belief.speeds_mps[belief.robot] : graph_->lengths_m(vertex)[k];
  const float w = static_cast<float>(length_m / graph_->mean_edge_length_m());
  const float m = mean_idleness_;
  const float weight = static_cast<float>(graph_->weights()[candidate]);
  const float robots = static_cast<float>(team_size);
  const float vertices = static_cast<float>(graph_->vertex_count());

  float claimed = 0.0f;
  float on_arrival = stays ? 0.0f : idleness_[candidate] + weight * w;
  float crowding = 0.0f;
  for (const OtherRobot& other : team_.others()) {
    const float until = other.remaining + distances.distance(other.target, candidate) * other.pace;
    crowding += std::exp(-0.5f * until);
    if (other.target != candidate) continue;
    claimed = 1.0f;
    if (other.remaining <= w + kTolerance) {
      on_arrival = std::min(on_arrival, weight * std::max(0.0f, w - other.remaining));
    }
  }
  const float lead = 0.5f * std::clamp(team_.earliest()[candidate] - w, -4.0f, 4.0f);
  const int arc = stays ? 2 * graph_->edge_count() : graph_->first_arc(vertex) + k;
  const Scan scan = ScanVertices(arc, candidate, w);

  const std::array<float, kFeatures> values = {
      w,
      idleness_[candidate] / m,
      on_arrival / m,
      claimed,
      std::log1p(on_arrival / m) - std::log(w + 0.1f),
      lead,
      crowding,
      static_cast<float>(graph_->degree(candidate)) / 3.0f,
      belief.previous_vertex == candidate ? 1.0f : 0.0f,
      scan.around[0] / m,
      scan.around[1] / m,
      scan.around[2] / m,
      scan.own_around[0] / m,
      scan.own_around[1] / m,
      scan.own_around[2] / m,
      std::log1p(scan.best / m),
      std::log1p(scan.best_own / m),
      scan.count * robots / vertices,
      idleness_[candidate] / largest_worthwhile_,
      claimed * lead,
      scan.count > 0.0f ? scan.sum / scan.count / m : 0.0f,
      scan.sum,  // divided by the candidates' sum once all are known
      4.0f * robots / vertices,
      static_cast<float>(graph_->degree(vertex)) / 3.0f,
      scan.largest / largest_worthwhile_,
      std::log(m * robots / vertices + 0.001f),
  };
  std::copy(values.begin(), values.end(), features);
}

void CandidateEncoder::Encode(const Belief& belief, std::span<float> observation,
                              std::span<std::uint8_t> legal_actions) {
  RONDA_CHECK(static_cast<int>(observation.size()) == observation_size() &&
                  static_cast<int>(legal_actions.size()) == num_actions(),
              "{} floats and {} actions for an observation of {} and {}", observation.size(),
              legal_actions.size(), observation_size(), num_actions());
  team_.Observe(belief);
  ObserveIdleness(belief);
  const int candidates = graph_->degree(belief.vertex) + (stay_ && belief.stay_s > 0.0 ? 1 : 0);
  const int team_size = belief.team_size();
  float sum = 0.0f;
  for (int k = 0; k < candidates; ++k) {
    float* const features = &observation[static_cast<std::size_t>(k) * kFeatures];
    EncodeCandidate(belief, k, team_size, features);
    sum += features[kShareOfSum];
  }
  for (int k = 0; k < candidates; ++k) {
    observation[static_cast<std::size_t>(k) * kFeatures + kShareOfSum] /= std::max(kFloor, sum);
  }
  const auto used = observation.first(static_cast<std::size_t>(candidates) * kFeatures);
  for (float& feature : used) feature = std::clamp(feature, -kLargestFeature, kLargestFeature);
  std::fill(observation.begin() + static_cast<std::ptrdiff_t>(used.size()), observation.end(),
            0.0f);
  std::fill(legal_actions.begin(), legal_actions.end(), std::uint8_t{0});
  std::fill_n(legal_actions.begin(), candidates, std::uint8_t{1});
}

}  // namespace ronda
