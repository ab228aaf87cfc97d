#pragma once
// Cyclic (Chevaleyre 2004): all robots follow one closed walk through all vertices.
//
// They start evenly spaced along it, the first on the walk's first vertex, the others also in the
// middle of an edge. A robot knows the walk and where on it it stands. No randomness.
#include <vector>

#include "common/world/strategies/strategy.h"

namespace ronda {

class Cyclic final : public Strategy {
 public:
  /// `walk` must outlive the strategy.
  explicit Cyclic(const ClosedWalk& walk) : walk_(&walk) {}

  std::vector<RobotStart> Begin(const PatrolGraph& graph, std::span<const double> speeds_mps,
                                Rng& rng) override;
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& belief, Rng& rng) override;

 private:
  std::size_t After(std::size_t index) const {
    return index + 1 == walk_->vertices.size() ? 0 : index + 1;
  }

  const ClosedWalk* walk_;
  std::vector<std::size_t> index_;  // (N): place in the walk where the robot stands or arrives next
};

}  // namespace ronda
