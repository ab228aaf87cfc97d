#include "common/world/strategies/strategy.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "common/base/error.h"
#include "common/world/strategies/conscientious_reactive.h"
#include "common/world/strategies/cyclic.h"
#include "common/world/strategies/expected_reactive.h"
#include "common/world/strategies/greedy_expected_idleness.h"
#include "common/world/strategies/random_walk.h"
#include "common/world/strategies/sebs.h"

namespace ronda {
namespace {

constexpr std::string_view kGeiPrefix = "gei:";

double LengthExponent(const std::string& name) {
  const std::string text = name.substr(kGeiPrefix.size());
  char* end = nullptr;
  const double exponent = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(exponent >= 0.0) || !std::isfinite(exponent)) {
    throw UsageError(fmt::format("strategy gei:P: P must be a finite number ≥ 0, got '{}'", text));
  }
  return exponent;
}

}  // namespace

std::vector<RobotStart> Strategy::Begin(const PatrolGraph& graph,
                                        std::span<const double> speeds_mps, Rng& rng) {
  return PatrolWorld::RandomStarts(graph, static_cast<int>(speeds_mps.size()), rng);
}

std::unique_ptr<Strategy> MakeStrategy(const std::string& name, const StrategyContext& context) {
  if (name == "random") return std::make_unique<RandomWalk>();
  if (name == "cr") return std::make_unique<ConscientiousReactive>();
  if (name == "sebs") return std::make_unique<StateExchangeBayesian>();
  if (name == "er") return std::make_unique<ExpectedReactive>();
  if (name == "gei") return std::make_unique<GreedyExpectedIdleness>(0.5);
  if (name.starts_with(kGeiPrefix)) {
    return std::make_unique<GreedyExpectedIdleness>(LengthExponent(name));
  }
  if (name == "cyclic") return std::make_unique<Cyclic>(*context.closed_walk);
  throw UsageError(fmt::format(
      "no strategy is called '{}'; there are random, cr, sebs, er, gei (= gei:0.5), gei:P, cyclic",
      name));
}

std::vector<std::string> AllStrategyNames() {
  return {"random", "cr", "sebs", "er", "gei:0", "gei:0.5", "gei:1", "cyclic"};
}

std::string StrategyKnowledge(const std::string& name) {
  if (name == "random") return "nothing";
  if (name == "cr") return "own visits";
  if (name == "cyclic") return "the walk";
  if (name == "sebs") return "all visits, targets";
  return "all visits, arrivals";
}

}  // namespace ronda
