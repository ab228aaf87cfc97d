#include "common/world/strategies/strategy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
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
constexpr std::string_view kAnnounced = "all visits, arrivals";

struct Row {
  std::string_view name;
  std::string_view knowledge;
  std::unique_ptr<Strategy> (*make)(const StrategyContext&);
};

/// One strategy that takes no part of the context.
template <class T>
std::unique_ptr<Strategy> Make(const StrategyContext&) {
  return std::make_unique<T>();
}

template <int kHalves>
std::unique_ptr<Strategy> MakeGei(const StrategyContext&) {
  return std::make_unique<GreedyExpectedIdleness>(0.5 * kHalves);
}

/// What `all` stands for, in this order; gei:P has any P.
constexpr Row kRows[] = {
    {"random", "nothing", Make<RandomWalk>},
    {"cr", "own visits", Make<ConscientiousReactive>},
    {"sebs", "all visits, targets", Make<StateExchangeBayesian>},
    {"er", kAnnounced, Make<ExpectedReactive>},
    {"gei:0", kAnnounced, MakeGei<0>},
    {"gei:0.5", kAnnounced, MakeGei<1>},
    {"gei:1", kAnnounced, MakeGei<2>},
    {"cyclic", "the walk",
     [](const StrategyContext& context) -> std::unique_ptr<Strategy> {
       return std::make_unique<Cyclic>(*context.closed_walk);
     }},
};

const Row* Find(std::string_view name) {
  const auto row = std::ranges::find(kRows, name, &Row::name);
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
  if (name == "gei") return MakeGei<1>(context);
  if (name.starts_with(kGeiPrefix)) {
    return std::make_unique<GreedyExpectedIdleness>(LengthExponent(name));
  }
  if (const Row* row = Find(name)) return row->make(context);
  throw UsageError(fmt::format("no strategy is called '{}'; there are {}", name, StrategyNames()));
}

std::string StrategyNames() {
  std::string names;
  for (const Row& row : kRows) {
    if (!row.name.starts_with(kGeiPrefix)) names += fmt::format("{}, ", row.name);
  }
  return names + "gei (= gei:0.5), gei:P";
}

std::vector<std::string> AllStrategyNames() {
  std::vector<std::string> names;
  for (const Row& row : kRows) names.emplace_back(row.name);
  return names;
}

std::string StrategyKnowledge(const std::string& name) {
  const Row* row = Find(name);
  return std::string(row == nullptr ? kAnnounced : row->knowledge);  // gei:P has no row
}

}  // namespace ronda
