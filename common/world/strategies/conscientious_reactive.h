#pragma once
// Conscientious Reactive, CR (Machado, Ramalho, Zucker & Drogoul 2003): the neighbour that has been
// idle for longest.
//
// argmax I_j over the neighbours j. A robot knows its own visits only, its start being the first;
// the variants `cr:shared` and `cr:claims` know more (sharing.h). Ties at random.
#include <vector>

#include "common/world/strategies/sharing.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

class ConscientiousReactive final : public Strategy {
 public:
  explicit ConscientiousReactive(Sharing sharing) : sharing_(sharing) {}

  Knowledge knowledge() const override { return KnowledgeOf(sharing_); }
  int Decide(const Belief& belief, Rng& rng) override;

 private:
  Sharing sharing_;
  std::vector<int> candidates_;  // scratch
};

}  // namespace ronda
