#include "common/world/strategies/sharing.h"

#include <numeric>

namespace ronda {

void FindCandidates(const Belief& belief, Sharing sharing, std::vector<int>& places) {
  const auto neighbours = belief.graph->neighbours(belief.vertex);
  places.clear();
  if (sharing == Sharing::kClaims) {
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      if (!belief.claimed(neighbours[k])) places.push_back(static_cast<int>(k));
    }
  }
  if (!places.empty()) return;
  places.resize(neighbours.size());
  std::iota(places.begin(), places.end(), 0);
}

}  // namespace ronda
