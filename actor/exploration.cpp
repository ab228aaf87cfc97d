#include "actor/exploration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

void Require(bool holds, const char* name, const char* rule, double value) {
  if (!holds) {
    throw InputError(fmt::format("exploration.{}: must be {}, got {}", name, rule, value));
  }
}

}  // namespace

ExplorationDecay ParseExplorationDecay(const std::string& name) {
  for (const auto decay : {ExplorationDecay::kLinear, ExplorationDecay::kExponential}) {
    if (name == Name(decay)) return decay;
  }
  throw UsageError(
      fmt::format("the exploration's decay must be one of linear, exponential, got '{}'", name));
}

std::string_view Name(ExplorationDecay decay) {
  return decay == ExplorationDecay::kLinear ? "linear" : "exponential";
}

void CheckExploration(const ExplorationOptions& options) {
  const bool positive = options.decay == ExplorationDecay::kExponential;
  const char* const rule = positive ? "> 0 and ≤ 1 (exponential)" : "in 0 … 1";
  const auto is_probability = [positive](double value) {
    return (positive ? value > 0.0 : value >= 0.0) && value <= 1.0;
  };
  Require(is_probability(options.start), "start", rule, options.start);
  Require(is_probability(options.end), "end", rule, options.end);
  Require(options.share > 0.0 && options.share <= 1.0, "share", "> 0 and ≤ 1", options.share);
  Require(options.ladder >= 0.0 && std::isfinite(options.ladder), "ladder", "≥ 0", options.ladder);
}

double ScheduledEpsilon(const ExplorationOptions& options, double progress) {
  const double way = std::clamp(progress / options.share, 0.0, 1.0);
  if (options.decay == ExplorationDecay::kExponential) {
    return options.start * std::pow(options.end / options.start, way);
  }
  return options.start + (options.end - options.start) * way;
}

double Epsilon(const ExplorationOptions& options, double progress, int index, int actors) {
  RONDA_CHECK(0 <= index && index < actors, "actor {} of {}", index, actors);
  const double rung = actors > 1 ? static_cast<double>(index) / (actors - 1) : 0.0;
  return std::pow(ScheduledEpsilon(options, progress), 1.0 + options.ladder * rung);
}

}  // namespace ronda
