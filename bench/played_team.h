#pragma once
// Teams that play a strategy without end, where everyone hears everything: what the benches of the
// world time.
#include <memory>
#include <string>
#include <vector>

#include "bench/rounds.h"
#include "common/world/strategies/strategy.h"

namespace ronda::bench {

/// The bare event loop: always the first neighbour, and nothing known.
class FirstNeighbour final : public Strategy {
 public:
  Knowledge knowledge() const override { return {}; }
  int Decide(const Belief& belief, Rng& /*rng*/) override {
    return belief.graph->neighbours(belief.vertex)[0];
  }
};

/// Not movable: its beliefs know its world.
class PlayedTeam {
 public:
  /// `graph` must outlive it. Robots move at 1 m/s; all random choices follow from one fixed seed.
  PlayedTeam(const PatrolGraph& graph, std::unique_ptr<Strategy> strategy, int robots)
      : strategy_(std::move(strategy)),
        speeds_mps_(robots, 1.0),
        rng_(SplitSeed(1, 0)),
        world_(graph, {.speeds_mps = speeds_mps_}),
        beliefs_(graph, robots, strategy_->knowledge(), {}) {
    world_.Reset(strategy_->Begin(graph, speeds_mps_, rng_), SplitSeed(1, 1));
    beliefs_.Begin(world_, Rng(1));
  }
  PlayedTeam(const PlayedTeam&) = delete;
  PlayedTeam& operator=(const PlayedTeam&) = delete;

  void Play(int decisions) {
    for (int i = 0; i < decisions; ++i) PlayNext(world_, beliefs_, *strategy_, 1e18, rng_);
  }

 private:
  std::unique_ptr<Strategy> strategy_;
  std::vector<double> speeds_mps_;
  Rng rng_;
  PatrolWorld world_;
  TeamBeliefs beliefs_;
};

/// The bare event loop and then all strategies, in the order of AllStrategyNames, measured in turn:
/// decisions a second of each in each round.
inline std::vector<Rates> DecisionRates(const StrategyContext& context, int robots, double slice_s,
                                        int rounds) {
  constexpr int kDecisions = 16;  // between two looks at the clock
  std::vector<std::unique_ptr<Strategy>> strategies;
  strategies.push_back(std::make_unique<FirstNeighbour>());
  for (const std::string& name : AllStrategyNames()) {
    strategies.push_back(MakeStrategy(name, context));
  }
  std::vector<std::unique_ptr<PlayedTeam>> teams;
  std::vector<std::function<void()>> calls;
  for (auto& strategy : strategies) {
    teams.push_back(std::make_unique<PlayedTeam>(*context.graph, std::move(strategy), robots));
    calls.emplace_back([team = teams.back().get()] { team->Play(kDecisions); });
  }
  std::vector<Rates> rates = MeasureInTurn(slice_s, rounds, calls);
  for (Rates& strategy : rates) {
    for (double& rate : strategy) rate *= kDecisions;
  }
  return rates;
}

}  // namespace ronda::bench
