#pragma once
// The observation that one scorer can read on any map: 26 features for each neighbour that a robot
// may go to next.
//
// Candidate k is the k-th neighbour (ascending) of the vertex where the robot stands; its row is
// observation[26 k … 26 k + 25], and action k goes there. Rows of candidates that do not exist are
// 0 and not legal. A = largest degree of the graph, O = 26 A; where staying put is an action, one
// more: its w is what the robot would go in that time, and nothing is behind it. N counts the
// robots on patrol. `kCandidateFeatureNames` says what the features are; in the text below u is the
// robot's vertex, v the candidate at distance w, e(x) the idleness of x (0 for u and where another
// robot heads to), eta(x) the earliest time until another robot can be at x, own = {x : w + d(v, x)
// < eta(x)} and behind = {x ≠ u : d(u, x) ≥ w + d(v, x)}, both with a tolerance of 1e-5 ℓ.
//
// Lengths are in units of the mean edge ℓ and times in units of what this robot takes for ℓ, so the
// features depend on no speed; idleness is divided by the present mean m. The mean, the largest e
// and the sum of "share_of_sum" are floored at 1e-6 units. All features lie in [−8, 8]. N = 1:
// eta = ∞. O(A·V + N·V) a call, no allocation once warm; O(V² + E·V) memory, shared by copies.
// Thread-compatible. Source: thesis §3.3 (what others announce added), kernels and subtrees ours.
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/environments/team_arrivals.h"
#include "common/world/belief.h"
#include "common/world/shortest_paths.h"

namespace ronda {

inline constexpr std::array kCandidateFeatureNames = {
    "distance",               // w
    "idleness",               // of v, /m
    "idleness_on_arrival",    // /m; announced arrivals before that count as visits
    "claimed",                // 1: another robot heads to v
    "log_idleness_rate",      // log1p(idleness_on_arrival) − log(w + 0.1)
    "lead",                   // (eta(v) − w) in ± 4, halved
    "crowding",               // Σ over other robots of exp(−(time until it could be at v) / 2)
    "degree",                 // of v, /3
    "came_from",              // 1: the robot came from v
    "idleness_within_1",      // mean of e weighted by exp(−d(v, x)), /m
    "idleness_within_3",      // by exp(−d / 3)
    "idleness_within_9",      // by exp(−d / 9)
    "own_idleness_within_1",  // the same over own only, divided by the weights of all
    "own_idleness_within_3", "own_idleness_within_9",
    "best_behind",        // log1p of the best (e + t) / (t + 0.3) / m, t = w + d(v, x), over
                          // behind with e(x) > 0; 0 if none
    "best_own_behind",    // the same over behind ∩ own
    "own_behind_count",   // |behind ∩ own| · N / V
    "idleness_of_max",    // idleness of v / largest e
    "claimed_lead",       // claimed · lead
    "own_behind_mean",    // mean e over behind ∩ own, /m; 0 if none
    "share_of_sum",       // Σ e over behind ∩ own, as a share of the sum over the candidates
    "robots_per_vertex",  // 4 N / V
    "candidates",         // number of candidates / 3
    "own_behind_max",     // largest e over behind ∩ own / largest e
    "log_mean_idleness",  // log(m · N / V + 0.001)
};

class CandidateEncoder {
 public:
  static constexpr int kFeatures = static_cast<int>(kCandidateFeatureNames.size());

  /// `graph` must outlive it; `paths` are the graph's. `stay`: staying put is an action where it is
  /// legal, the one after the neighbours.
  CandidateEncoder(const PatrolGraph& graph, const ShortestPaths& paths, bool stay);

  int num_actions() const { return graph_->max_degree() + (stay_ ? 1 : 0); }
  int observation_size() const { return num_actions() * kFeatures; }
  /// Sizes O and A.
  void Encode(const Belief& belief, std::span<float> observation,
              std::span<std::uint8_t> legal_actions);
  int NextVertex(int vertex, int action) const {
    return action < graph_->degree(vertex) ? graph_->neighbours(vertex)[action] : vertex;
  }

 private:
  struct Tables;
  struct Scan;

  void ObserveIdleness(const Belief& belief);
  Scan ScanVertices(int arc, int candidate, float distance) const;
  void EncodeCandidate(const Belief& belief, int k, int team_size, float* features) const;

  const PatrolGraph* graph_;
  bool stay_;
  std::shared_ptr<const Tables> tables_;
  TeamArrivals team_;
  std::vector<float> idleness_;      // (stride) units
  std::vector<float> worthwhile_;    // (stride) e
  float mean_idleness_ = 0.0f;       // m, floored
  float largest_worthwhile_ = 0.0f;  // max e, floored
};

}  // namespace ronda
