#pragma once
// How a strategy is judged: episodes of the patrolled world under a named protocol.
//
// steady: random starts, warm-up 20 T_ref, then a window of 60 T_ref, where T_ref is the length of
// the map's shortest closed walk over the sum of speeds. thesis: from zero idleness to a fixed
// horizon, no warm-up. AGI and WI count over the window; final idleness is the mean idleness at the
// episode's end. Episode e draws starts, noise, decisions, failures and lost messages from streams
// of its own, split from the seed, so every strategy sees the same starts and results do not depend
// on the number of threads. Source: thesis §4.3; docs/evaluation.md.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "common/evaluation/statistics.h"
#include "common/evaluation/trace.h"
#include "common/world/conditions.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

enum class Protocol { kSteady, kThesis };

inline constexpr double kWarmupTref = 20.0;  // of the steady protocol, in T_ref
inline constexpr double kWindowTref = 60.0;

struct EvaluationOptions {
  Protocol protocol = Protocol::kSteady;
  double horizon_s = 600.0;  // of the thesis protocol, > 0
  int episodes = 20;         // 1 … kMaxEpisodes
  std::uint64_t seed = 1;
  int agents = 1;  // 1 … kMaxAgents
  Conditions conditions = {};
  int threads = 0;  // 0: one for each core; with a trace always one
};

inline constexpr int kMaxAgents = 10'000;
inline constexpr int kMaxEpisodes = 1'000'000;

struct EpisodeResult {
  double agi_s = 0.0;
  double wi_s = 0.0;
  double final_s = 0.0;
  std::int64_t decisions = 0;  // warm-up included
};

struct EvaluationResult {
  double t_ref_s = 0.0;
  double warmup_s = 0.0;
  double window_s = 0.0;
  std::vector<EpisodeResult> episodes;

  std::vector<double> agi_s() const;    // (episodes)
  std::vector<double> wi_s() const;     // (episodes)
  std::vector<double> final_s() const;  // (episodes)
  std::int64_t decisions() const;
};

/// Makes a strategy for one thread; called from several.
using StrategyFactory = std::function<std::unique_ptr<Strategy>()>;

/// Throws UsageError that names option, rule and value where an option is out of its range.
void CheckOptions(const EvaluationOptions& options);

/// One strategy under one set of options.
struct Evaluation {
  StrategyContext context;
  StrategyFactory make_strategy;
  EvaluationOptions options;
};

/// What EvaluateAll tells while it works. Called from its threads, one call at a time.
struct EvaluationListener {
  std::function<void(std::size_t evaluation, const EpisodeResult&)> on_episode;
  std::function<void(std::size_t evaluation, EvaluationResult)> on_result;
};

/// When the protocol measures, in a result without episodes.
EvaluationResult ProtocolTimes(const StrategyContext& context, const EvaluationOptions& options);

/// Plays the episodes of all evaluations over one queue, in order, so that no core waits for the
/// last episode of one while another has some left. `threads` 0: one for each core. False when
/// `stop` was requested before the end: what was reported until then is whole. Throws as
/// CheckOptions, and what a strategy or the listener throws.
bool EvaluateAll(std::span<const Evaluation> evaluations, int threads,
                 const EvaluationListener& listener, std::stop_token stop = {});

/// Plays all episodes; `trace` may be null. nullopt when `stop` was requested before the end.
/// Throws as CheckOptions, and what the strategy throws.
std::optional<EvaluationResult> Evaluate(const StrategyContext& context,
                                         const StrategyFactory& make_strategy,
                                         const EvaluationOptions& options, TraceWriter* trace,
                                         std::stop_token stop = {});

std::string_view ProtocolName(Protocol protocol);  // steady | thesis

}  // namespace ronda
