#include "common/world/strategies/random_walk.h"

#include <cstdint>

namespace ronda {

int RandomWalk::Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) {
  const auto neighbours = world.graph().neighbours(arrival.vertex);
  return neighbours[rng.Below(static_cast<std::uint32_t>(neighbours.size()))];
}

}  // namespace ronda
