#include "common/world/strategies/random_walk.h"

#include <cstdint>

namespace ronda {

int RandomWalk::Decide(const Belief& belief, Rng& rng) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  return neighbours[rng.Below(static_cast<std::uint32_t>(neighbours.size()))];
}

}  // namespace ronda
