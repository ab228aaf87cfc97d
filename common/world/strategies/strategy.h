#pragma once
// A patrol strategy: tells a robot that has arrived at a vertex which neighbour to go to next.
//
// Classical baselines implement it one a file; a trained network does through
// team/policy_strategy. One object serves the whole team; it keeps what its robots know.
// Thread-compatible: one object for each thread.
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/base/rng.h"
#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"

namespace ronda {

class Strategy {
 public:
  virtual ~Strategy() = default;

  /// Starts an episode: forgets everything, and says where the robots start. By default
  /// PatrolWorld::RandomStarts.
  virtual std::vector<RobotStart> Begin(const PatrolGraph& graph,
                                        std::span<const double> speeds_mps, Rng& rng);

  /// The neighbour of arrival.vertex to go to. Called for every arrival, in order; ties are broken
  /// with `rng`.
  virtual int Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) = 0;
};

/// What the classical strategies may need of a map, made once and shared.
struct StrategyContext {
  const PatrolGraph* graph = nullptr;
  const ShortestPaths* paths = nullptr;
  const ClosedWalk* closed_walk = nullptr;
};

/// Makes a strategy by its name on the command line. Throws UsageError that lists the names when
/// there is none of that name or the P of gei:P is not a number ≥ 0.
std::unique_ptr<Strategy> MakeStrategy(const std::string& name, const StrategyContext& context);

/// "random, cr, …", for a sentence.
std::string StrategyNames();

/// What `all` stands for.
std::vector<std::string> AllStrategyNames();

/// What the robots of a strategy know when they decide, in a few words for a table.
std::string StrategyKnowledge(const std::string& name);

}  // namespace ronda
