#pragma once
// A patrol strategy: tells a robot that has arrived at a vertex which neighbour to go to next.
//
// Classical baselines implement it one a file; a trained network does through
// team/policy_strategy. One object serves the whole team; it keeps what its robots know.
// Thread-compatible: one object for each thread.
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/rng.h"
#include "common/world/belief.h"
#include "common/world/patrol_world.h"
#include "common/world/shortest_paths.h"
#include "common/world/team_beliefs.h"

namespace ronda {

class Strategy {
 public:
  virtual ~Strategy() = default;

  /// Starts an episode: forgets everything, and says where the robots start. By default
  /// PatrolWorld::RandomStarts.
  virtual std::vector<RobotStart> Begin(const PatrolGraph& graph,
                                        std::span<const double> speeds_mps, Rng& rng);

  /// What its robots make use of; they get no more.
  virtual Knowledge knowledge() const = 0;

  /// The neighbour of belief.vertex to go to (or that vertex, where staying put is legal). Called
  /// for every arrival, in order; ties are broken with `rng`.
  virtual int Decide(const Belief& belief, Rng& rng) = 0;

  /// `receiver` has heard what `sender` said when it decided last; only where
  /// knowledge() says `messages`.
  virtual void Hear(int /*receiver*/, int /*sender*/) {}
};

/// The next arrival at or before `until_s`, with its decision made and announced; nullopt when
/// there is none.
inline std::optional<Arrival> PlayNext(PatrolWorld& world, TeamBeliefs& beliefs, Strategy& strategy,
                                       double until_s, Rng& rng) {
  const auto arrival = world.NextArrival(until_s);
  if (!arrival) return std::nullopt;
  world.Depart(arrival->robot, strategy.Decide(beliefs.Arrived(world, *arrival), rng));
  beliefs.Departed(world, arrival->robot);
  return arrival;
}

/// What the classical strategies may need of a map, made once and shared.
struct StrategyContext {
  const PatrolGraph* graph = nullptr;
  const ShortestPaths* paths = nullptr;
  const ClosedWalk* closed_walk = nullptr;
};

/// Makes a strategy by its name on the command line. Throws UsageError that lists the names when
/// there is none of that name or the P of gei:P is not a number ≥ 0.
std::unique_ptr<Strategy> MakeStrategy(const std::string& name, const StrategyContext& context);

/// What a strategy is, in a few words each.
struct StrategyInfo {
  std::string_view name;       // on the command line
  std::string_view rule;       // where its robots go
  std::string_view knowledge;  // what they know when they decide
  std::string_view source;     // who described it

  /// Of the strategy whose name stands before the colon.
  constexpr bool is_variant() const { return name.find(':') != name.npos; }
};

/// All that have a name: what `all` stands for, then the variants.
std::vector<StrategyInfo> KnownStrategies();

/// "random, cr, …", for a sentence.
std::string StrategyNames();

/// What `all` stands for.
std::vector<std::string> AllStrategyNames();

/// StrategyInfo::knowledge of a strategy that there is.
std::string StrategyKnowledge(const std::string& name);

}  // namespace ronda
