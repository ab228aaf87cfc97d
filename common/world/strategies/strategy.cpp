#include "common/world/strategies/strategy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "common/base/error.h"
#include "common/world/strategies/ahpa.h"
#include "common/world/strategies/cbls.h"
#include "common/world/strategies/conscientious_reactive.h"
#include "common/world/strategies/cyclic.h"
#include "common/world/strategies/dtag.h"
#include "common/world/strategies/dtap.h"
#include "common/world/strategies/expected_reactive.h"
#include "common/world/strategies/gbs.h"
#include "common/world/strategies/greedy_expected_idleness.h"
#include "common/world/strategies/hcr.h"
#include "common/world/strategies/hpcc.h"
#include "common/world/strategies/random_walk.h"
#include "common/world/strategies/sebs.h"

namespace ronda {
namespace {

constexpr std::string_view kGeiPrefix = "gei:";
constexpr std::string_view kVariant = "a variant, to compare";
constexpr double kUsualExponent = 0.5;

struct Row {
  StrategyInfo info;
  std::unique_ptr<Strategy> (*make)(const StrategyContext&);
};

/// One strategy that takes no part of the context.
template <class T>
std::unique_ptr<Strategy> Make(const StrategyContext&) {
  return std::make_unique<T>();
}

template <class T, Sharing kSharing>
std::unique_ptr<Strategy> MakeSharing(const StrategyContext&) {
  return std::make_unique<T>(kSharing);
}

template <class T>
std::unique_ptr<Strategy> MakeOnPaths(const StrategyContext& context) {
  return std::make_unique<T>(*context.graph, *context.paths);
}

/// What `all` stands for, in this order, then the variants.
constexpr Row kRows[] = {
    {{.name = "random",
      .rule = "a uniformly random neighbour",
      .knowledge = "nothing",
      .source = "thesis §4.3"},
     Make<RandomWalk>},
    {{.name = "cr",
      .rule = "Conscientious Reactive: the most idle neighbour",
      .knowledge = "own visits",
      .source = "Machado, Ramalho, Zucker & Drogoul 2003"},
     MakeSharing<ConscientiousReactive, Sharing::kOwn>},
    {{.name = "hcr",
      .rule = "Heuristic Conscientious Reactive: a near and idle neighbour",
      .knowledge = "own visits",
      .source = "Almeida et al. 2004"},
     MakeSharing<HeuristicReactive, Sharing::kOwn>},
    {{.name = "hpcc",
      .rule =
          "Heuristic Pathfinder Conscientious Cognitive: a near and idle vertex, by an idle way",
      .knowledge = "own visits",
      .source = "Almeida et al. 2004"},
     MakeOnPaths<HeuristicPathfinder>},
    {{.name = "cyclic",
      .rule = "one short closed walk, all evenly spaced along it",
      .knowledge = "the walk",
      .source = "Chevaleyre 2004"},
     [](const StrategyContext& context) -> std::unique_ptr<Strategy> {
       return std::make_unique<Cyclic>(*context.closed_walk);
     }},
    {{.name = "gbs",
      .rule = "Greedy Bayesian Strategy: the neighbour of the greatest gain",
      .knowledge = "all visits",
      .source = "Portugal & Rocha 2013"},
     MakeSharing<GreedyBayesian, Sharing::kShared>},
    {{.name = "sebs",
      .rule = "State Exchange Bayesian Strategy: GBS, less for each robot that heads there",
      .knowledge = "all visits, targets",
      .source = "Portugal & Rocha 2013"},
     Make<StateExchangeBayesian>},
    {{.name = "cbls",
      .rule = "Concurrent Bayesian Learning: GBS's kind, with arcs that learn",
      .knowledge = "all visits, targets",
      .source = "Portugal & Rocha 2016"},
     Make<ConcurrentBayesianLearning>},
    {{.name = "dtag",
      .rule = "Dynamic Task Assignment, Greedy: the best vertex anywhere that is no other's goal",
      .knowledge = "all visits, goals",
      .source = "Farinelli, Iocchi & Nardi 2017"},
     MakeOnPaths<GreedyAssignment>},
    {{.name = "dtap",
      .rule = "Dynamic Task Assignment by auction: the best vertex anywhere that it wins",
      .knowledge = "all visits, bids, goals",
      .source = "Farinelli, Iocchi & Nardi 2017"},
     MakeOnPaths<AuctionAssignment>},
    {{.name = "er",
      .rule = "Expected Reactive: the longest expected gap between visits, per length",
      .knowledge = "all visits, arrivals",
      .source = "Yan & Zhang 2016"},
     Make<ExpectedReactive>},
    {{.name = "gei",
      .rule = "Greedy on Expected Idleness over length^P, P = 0.5 (gei:P has any P ≥ 0)",
      .knowledge = "all visits, arrivals",
      .source = "a yardstick of this project"},
     [](const StrategyContext&) -> std::unique_ptr<Strategy> {
       return std::make_unique<GreedyExpectedIdleness>(kUsualExponent);
     }},
    {{.name = "ahpa",
      .rule = "Adaptive Heuristic-based Patrolling: each goes round its own cell",
      .knowledge = "targets, plans",
      .source = "Goeckner, Li, Wei & Zhu 2024"},
     MakeOnPaths<PatrolOfCells>},
    {{.name = "cr:shared",
      .rule = "CR on everyone's visits",
      .knowledge = "all visits",
      .source = kVariant},
     MakeSharing<ConscientiousReactive, Sharing::kShared>},
    {{.name = "cr:claims",
      .rule = "CR on everyone's visits, not where another heads",
      .knowledge = "all visits, targets",
      .source = kVariant},
     MakeSharing<ConscientiousReactive, Sharing::kClaims>},
    {{.name = "hcr:shared",
      .rule = "HCR on everyone's visits",
      .knowledge = "all visits",
      .source = kVariant},
     MakeSharing<HeuristicReactive, Sharing::kShared>},
    {{.name = "hcr:claims",
      .rule = "HCR on everyone's visits, not where another heads",
      .knowledge = "all visits, targets",
      .source = kVariant},
     MakeSharing<HeuristicReactive, Sharing::kClaims>},
    {{.name = "gbs:claims",
      .rule = "GBS, not where another heads",
      .knowledge = "all visits, targets",
      .source = kVariant},
     MakeSharing<GreedyBayesian, Sharing::kClaims>},
};

const Row* Find(std::string_view name) {
  if (name.starts_with(kGeiPrefix)) name = "gei";
  const auto row =
      std::ranges::find_if(kRows, [&](const Row& each) { return each.info.name == name; });
  return row == std::end(kRows) ? nullptr : row;
}

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
  if (name.starts_with(kGeiPrefix)) {
    return std::make_unique<GreedyExpectedIdleness>(LengthExponent(name));
  }
  if (const Row* row = Find(name)) return row->make(context);
  throw UsageError(fmt::format("no strategy is called '{}'; there are {}", name, StrategyNames()));
}

std::vector<StrategyInfo> KnownStrategies() {
  std::vector<StrategyInfo> known;
  for (const Row& row : kRows) known.push_back(row.info);
  return known;
}

std::string StrategyNames() {
  std::string names;
  for (const Row& row : kRows) names += fmt::format("{}, ", row.info.name);
  return names + "gei:P";
}

std::vector<std::string> AllStrategyNames() {
  std::vector<std::string> names;
  for (const Row& row : kRows) {
    if (!row.info.is_variant()) names.emplace_back(row.info.name);
  }
  return names;
}

std::string StrategyKnowledge(const std::string& name) {
  return std::string(Find(name)->info.knowledge);
}

}  // namespace ronda
