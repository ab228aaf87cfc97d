#include "common/world/strategies/cbls.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/world/strategies/random_argmax.h"
#include "common/world/strategies/share_of.h"
#include "common/world/strategies/sharing.h"

namespace ronda {
namespace {

/// Of what is in proportion to `masses`: 1 where all are alike, 0 where one has all.
double RelativeEntropy(const std::vector<double>& masses) {
  const double total = std::accumulate(masses.begin(), masses.end(), 0.0);
  if (total == 0.0) return 1.0;
  double entropy = 0.0;
  for (const double mass : masses) {
    const double share = mass / total;
    if (share > 0.0) entropy -= share * std::log(share);
  }
  return ShareOf(entropy, std::log(static_cast<double>(masses.size())));
}

}  // namespace

std::vector<RobotStart> ConcurrentBayesianLearning::Begin(const PatrolGraph& graph,
                                                          std::span<const double> speeds_mps,
                                                          Rng& rng) {
  vertices_ = static_cast<std::size_t>(graph.vertex_count());
  arcs_ = 2 * static_cast<std::size_t>(graph.edge_count());
  visits_.assign(speeds_mps.size() * vertices_, 0);
  visited_.assign(speeds_mps.size(), -1);
  likelihoods_.assign(speeds_mps.size() * arcs_, 1.0);
  choices_.resize(speeds_mps.size());
  return Strategy::Begin(graph, speeds_mps, rng);
}

int ConcurrentBayesianLearning::Decide(const Belief& belief, Rng& rng) {
  visited_[belief.robot] = belief.time_s > 0.0 ? belief.vertex : -1;
  CountVisit(belief.robot, visited_[belief.robot]);
  Choice& choice = choices_[belief.robot];
  if (belief.previous_vertex >= 0) Learn(belief, choice);
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  choice.vertex = belief.vertex;
  FindCandidates(belief, Sharing::kClaims, choice.candidates);
  posteriors_.clear();
  for (const int k : choice.candidates) {
    posteriors_.push_back(Prior(belief, neighbours[k]) *
                          likelihood(belief.robot, belief.graph->first_arc(belief.vertex) + k));
  }
  choice.certainty = 1.0 - RelativeEntropy(posteriors_);
  return Best(belief, choice.candidates, rng);
}

void ConcurrentBayesianLearning::Hear(int receiver, int sender) {
  CountVisit(receiver, visited_[sender]);
}

void ConcurrentBayesianLearning::CountVisit(int robot, int vertex) {
  if (vertex >= 0) ++visits_[vertices_ * robot + vertex];
}

double ConcurrentBayesianLearning::MeanIdleness_s(const Belief& belief, int vertex) const {
  return belief.graph->weights()[vertex] * belief.time_s /
         (visits_[vertices_ * belief.robot + vertex] + 1.0);
}

double ConcurrentBayesianLearning::Prior(const Belief& belief, int candidate) const {
  constexpr double kOwnShare = 0.75;
  const double own_s = MeanIdleness_s(belief, candidate);
  double beyond_s = -1.0;
  for (const int vertex : belief.graph->neighbours(candidate)) {
    if (vertex == belief.vertex || belief.claimed(vertex)) continue;
    beyond_s = std::max(beyond_s, MeanIdleness_s(belief, vertex));
  }
  return kOwnShare * own_s + (1.0 - kOwnShare) * (beyond_s < 0.0 ? own_s : beyond_s);
}

int ConcurrentBayesianLearning::Best(const Belief& belief, const std::vector<int>& candidates,
                                     Rng& rng) const {
  constexpr double kTolerance = 1e-9;  // as RandomArgmax has it
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  const auto lengths_m = belief.graph->lengths_m(belief.vertex);
  const double greatest = *std::max_element(posteriors_.begin(), posteriors_.end());
  RandomArgmax shortest(rng);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (posteriors_[c] >= (1.0 - kTolerance) * greatest) {
      shortest.Offer(neighbours[candidates[c]], -lengths_m[candidates[c]]);
    }
  }
  return shortest.best();
}

void ConcurrentBayesianLearning::Learn(const Belief& belief, const Choice& choice) {
  constexpr double kLowest = 0.5;
  constexpr double kHighest = 2.0;
  const auto neighbours = belief.graph->neighbours(choice.vertex);
  double most_idle_s = 0.0;
  double least_idle_s = kNever_s;
  for (const int k : choice.candidates) {
    most_idle_s = std::max(most_idle_s, belief.idleness_s(neighbours[k]));
    least_idle_s = std::min(least_idle_s, belief.idleness_s(neighbours[k]));
  }
  if (most_idle_s == least_idle_s) return;
  for (const int k : choice.candidates) {
    const double idleness_s = belief.idleness_s(neighbours[k]);
    const double sign = idleness_s == most_idle_s ? 1.0 : idleness_s == least_idle_s ? -1.0 : 0.0;
    double& value = likelihood(belief.robot, belief.graph->first_arc(choice.vertex) + k);
    value = std::clamp(value + sign * choice.certainty, kLowest, kHighest);
  }
}

}  // namespace ronda
