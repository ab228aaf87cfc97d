#pragma once
// A team whose decisions a test looks at one by one, or overrides.
#include <catch2/catch.hpp>
#include <optional>
#include <vector>

#include "common/world/strategies/strategy.h"

namespace ronda::testing {

class PlayedTeam {
 public:
  /// All must outlive it. Forgets what the strategy knew.
  PlayedTeam(const PatrolGraph& graph, Strategy& strategy, std::vector<double> speeds_mps,
             std::uint64_t seed, double travel_noise = 0.0)
      : world(graph, {.speeds_mps = speeds_mps, .travel_noise = travel_noise}),
        rng(SplitSeed(seed, 0)),
        strategy_(strategy),
        beliefs_(graph, world.robot_count(), strategy.knowledge(), {}) {
    beliefs_.OnHeard([this](int receiver, int sender) { strategy_.Hear(receiver, sender); });
    StartFrom(strategy.Begin(graph, speeds_mps, rng));
  }
  PlayedTeam(const PlayedTeam&) = delete;
  PlayedTeam& operator=(const PlayedTeam&) = delete;

  /// Instead of where the strategy starts.
  void StartFrom(const std::vector<RobotStart>& starts) {
    world.Reset(starts, Rng(1));
    beliefs_.Begin(world, Rng(1));
  }

  /// Plays the next arrival; where that robot goes.
  int DecideNext() { return Next(std::nullopt); }
  /// Lets the next robot decide, but sends it to `next`; what it decided.
  int DecideThenGo(int next) { return Next(next); }

  PatrolWorld world;
  Rng rng;

 private:
  int Next(std::optional<int> instead) {
    const auto arrival = world.NextArrival(1e9);
    REQUIRE(arrival);
    const int decided = strategy_.Decide(beliefs_.Arrived(world, *arrival), rng);
    world.Depart(arrival->robot, instead.value_or(decided));
    beliefs_.Departed(world, arrival->robot);
    return decided;
  }

  Strategy& strategy_;
  TeamBeliefs beliefs_;
};

}  // namespace ronda::testing
