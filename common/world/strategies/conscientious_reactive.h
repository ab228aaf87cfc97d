#pragma once
// Conscientious Reactive (Machado et al. 2003; Portugal & Rocha 2013): the neighbour that has been
// idle for longest. A robot knows its own visits only; its start is the first of them. Ties at
// random.
#include <vector>

#include "common/world/strategies/strategy.h"

namespace ronda {

class ConscientiousReactive final : public Strategy {
 public:
  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  int Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) override;

 private:
  std::vector<double> own_visits_s_;  // (N, V): when the robot was last there, 0 if never
};

}  // namespace ronda
