#pragma once
// Heuristic Conscientious Reactive, HCR (Almeida et al. 2004): a neighbour that is both near and
// idle.
//
// argmax over the neighbours j of (Cmax − c_j)/Cmax + I_j/Imax, c_j the length of the edge, I_j the
// idleness, the maxima over the same neighbours; 0/0 is 0. A robot knows its own visits only; the
// variants `hcr:shared` and `hcr:claims` know more (sharing.h), and take the maxima over the
// neighbours that they choose from. Ties at random.
#include <vector>

#include "common/world/strategies/sharing.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

class HeuristicReactive final : public Strategy {
 public:
  explicit HeuristicReactive(Sharing sharing) : sharing_(sharing) {}

  Knowledge knowledge() const override { return KnowledgeOf(sharing_); }
  int Decide(const Belief& belief, Rng& rng) override;

 private:
  Sharing sharing_;
  std::vector<int> candidates_;  // scratch
};

}  // namespace ronda
