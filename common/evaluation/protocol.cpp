#include "common/evaluation/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

/// Streams of one episode, split from the evaluation's seed.
struct EpisodeStreams {
  Rng starts;
  Rng noise;
  Rng decisions;
  Rng changes;
  Rng messages;

  EpisodeStreams(std::uint64_t seed, int episode)
      : starts(SplitSeed(seed, 3 * static_cast<std::uint64_t>(episode))),
        noise(SplitSeed(seed, 3 * static_cast<std::uint64_t>(episode) + 1)),
        decisions(SplitSeed(seed, 3 * static_cast<std::uint64_t>(episode) + 2)),
        changes(SplitSeed(~seed, 2 * static_cast<std::uint64_t>(episode))),
        messages(SplitSeed(~seed, 2 * static_cast<std::uint64_t>(episode) + 1)) {}
};

/// One thread's world and strategy, used for episode after episode.
class EpisodePlayer {
 public:
  EpisodePlayer(const StrategyContext& context, const StrategyFactory& make_strategy,
                const EvaluationOptions& options, const EvaluationResult& times)
      : seed_(options.seed),
        attrition_(options.conditions.attrition),
        warmup_s_(times.warmup_s),
        end_s_(times.warmup_s + times.window_s),
        strategy_(make_strategy()),
        world_(*context.graph, WorldOptionsOf(options.conditions, options.agents)),
        beliefs_(*context.graph, options.agents, strategy_->knowledge(),
                 options.conditions.communication) {
    beliefs_.OnHeard([this](int receiver, int sender) { strategy_->Hear(receiver, sender); });
  }
  EpisodePlayer(const EpisodePlayer&) = delete;
  EpisodePlayer& operator=(const EpisodePlayer&) = delete;

  /// nullopt when stopped.
  std::optional<EpisodeResult> Play(int episode, TraceWriter* trace, const std::stop_token& stop) {
    EpisodeStreams streams(seed_, episode);
    const auto starts = strategy_->Begin(world_.graph(), world_.speeds_mps(), streams.starts);
    world_.Reset(starts, streams.noise);
    const auto changes = DrawChanges(attrition_, world_.robot_count(), end_s_, streams.changes);
    world_.Schedule(changes);
    beliefs_.Begin(world_, streams.messages);
    std::optional<EpisodeTrace> episode_trace;
    if (trace != nullptr) episode_trace.emplace(*trace, episode, starts, changes);
    EpisodeResult result;
    const auto advance = [&](double until_s) {
      const bool finished =
          episode_trace
              ? Decide(until_s, streams.decisions, stop, result.decisions,
                       [&](const Arrival& arrival) { episode_trace->Visit(arrival); })
              : Decide(until_s, streams.decisions, stop, result.decisions, [](const Arrival&) {});
      if (finished) world_.AdvanceTo(until_s);
      return finished;
    };
    if (!advance(warmup_s_)) return std::nullopt;
    world_.BeginMeasurement();
    if (!advance(end_s_)) return std::nullopt;
    if (episode_trace) episode_trace->End(end_s_);
    result.agi_s = world_.average_graph_idleness_s();
    result.wi_s = world_.worst_idleness_s();
    result.final_s = world_.instantaneous_graph_idleness_s();
    return result;
  }

 private:
  /// All arrivals up to `until_s`, each with its decision; false when stopped.
  template <typename OnArrival>
  bool Decide(double until_s, Rng& rng, const std::stop_token& stop, std::int64_t& decisions,
              const OnArrival& on_arrival) {
    constexpr std::int64_t kStopInterval = 4096;
    while (const auto arrival = PlayNext(world_, beliefs_, *strategy_, until_s, rng)) {
      on_arrival(*arrival);
      if (++decisions % kStopInterval == 0 && stop.stop_requested()) return false;
    }
    return !stop.stop_requested();
  }

  std::uint64_t seed_;
  Attrition attrition_;
  double warmup_s_;
  double end_s_;
  std::unique_ptr<Strategy> strategy_;
  PatrolWorld world_;
  TeamBeliefs beliefs_;
};

/// One episode of one evaluation.
struct EpisodeTicket {
  std::size_t evaluation;
  int episode;
};

/// The episodes of all evaluations, dealt to threads one by one, and what came of them. The first
/// exception of any thread ends all and is thrown on. Thread-safe.
class EpisodeQueue {
 public:
  EpisodeQueue(std::span<const Evaluation> evaluations, const EvaluationListener& listener)
      : evaluations_(evaluations), listener_(listener), open_(evaluations.size()) {}

  /// The next episode, or nullopt when there is none left.
  std::optional<EpisodeTicket> Take() {
    const std::lock_guard lock(mutex_);
    if (error_ || next_.evaluation == evaluations_.size()) return std::nullopt;
    const EpisodeTicket ticket = next_;
    const Evaluation& evaluation = evaluations_[ticket.evaluation];
    if (ticket.episode == 0) {
      Open& open = open_[ticket.evaluation];
      open.result = ProtocolTimes(evaluation.context, evaluation.options);
      open.result.episodes.resize(static_cast<std::size_t>(evaluation.options.episodes));
      open.left = evaluation.options.episodes;
    }
    if (++next_.episode == evaluation.options.episodes) next_ = {ticket.evaluation + 1, 0};
    return ticket;
  }

  void Add(const EpisodeTicket& ticket, const EpisodeResult& result) {
    const std::lock_guard lock(mutex_);
    Open& open = open_[ticket.evaluation];
    open.result.episodes[static_cast<std::size_t>(ticket.episode)] = result;
    if (listener_.on_episode) listener_.on_episode(ticket.evaluation, result);
    if (--open.left > 0) return;
    ++finished_;
    listener_.on_result(ticket.evaluation, std::exchange(open.result, {}));
  }

  void Fail(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
  }

  /// When no thread works any more: whether all evaluations have their result.
  bool Finished() const {
    if (error_) std::rethrow_exception(error_);
    return finished_ == evaluations_.size();
  }

 private:
  struct Open {
    EvaluationResult result;
    int left = 0;  // episodes
  };

  std::span<const Evaluation> evaluations_;
  const EvaluationListener& listener_;
  std::mutex mutex_;
  EpisodeTicket next_{0, 0};
  std::vector<Open> open_;  // (evaluations)
  std::size_t finished_ = 0;
  std::exception_ptr error_;
};

/// One thread's work: plays what the queue deals until there is nothing left.
void PlayFrom(EpisodeQueue& queue, std::span<const Evaluation> evaluations, TraceWriter* trace,
              const std::stop_token& stop) {
  try {
    std::optional<EpisodePlayer> player;
    std::size_t of = evaluations.size();  // whose player it is
    while (const auto ticket = queue.Take()) {
      if (ticket->evaluation != of) {
        of = ticket->evaluation;
        const Evaluation& evaluation = evaluations[of];
        player.emplace(evaluation.context, evaluation.make_strategy, evaluation.options,
                       ProtocolTimes(evaluation.context, evaluation.options));
      }
      const auto result = player->Play(ticket->episode, trace, stop);
      if (!result) return;
      queue.Add(*ticket, *result);
    }
  } catch (...) {
    queue.Fail(std::current_exception());
  }
}

/// A trace is of one evaluation, on one thread.
bool PlayAll(std::span<const Evaluation> evaluations, int threads,
             const EvaluationListener& listener, TraceWriter* trace, const std::stop_token& stop) {
  std::int64_t episodes = 0;
  for (const Evaluation& evaluation : evaluations) {
    CheckOptions(evaluation.options);
    episodes += evaluation.options.episodes;
  }
  if (trace != nullptr) {
    const auto times = ProtocolTimes(evaluations[0].context, evaluations[0].options);
    trace->Begin(times.warmup_s, times.window_s);
  }
  EpisodeQueue queue(evaluations, listener);
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const std::int64_t wanted = std::min<std::int64_t>(threads > 0 ? threads : cores, episodes);
  {
    std::vector<std::jthread> helpers;
    for (std::int64_t i = 1; i < wanted; ++i) {
      helpers.emplace_back([&] { PlayFrom(queue, evaluations, trace, stop); });
    }
    PlayFrom(queue, evaluations, trace, stop);
  }
  return queue.Finished();
}

template <typename Field>
std::vector<double> Column(const std::vector<EpisodeResult>& episodes, Field field) {
  std::vector<double> column;
  column.reserve(episodes.size());
  for (const EpisodeResult& episode : episodes) column.push_back(episode.*field);
  return column;
}

}  // namespace

std::vector<double> EvaluationResult::agi_s() const {
  return Column(episodes, &EpisodeResult::agi_s);
}
std::vector<double> EvaluationResult::wi_s() const {
  return Column(episodes, &EpisodeResult::wi_s);
}
std::vector<double> EvaluationResult::final_s() const {
  return Column(episodes, &EpisodeResult::final_s);
}

std::int64_t EvaluationResult::decisions() const {
  std::int64_t sum = 0;
  for (const EpisodeResult& episode : episodes) sum += episode.decisions;
  return sum;
}

void CheckOptions(const EvaluationOptions& options) {
  const auto check = [](bool holds, std::string_view rule, auto value) {
    if (!holds) throw UsageError(fmt::format("{}, got {}", rule, value));
  };
  check(options.agents >= 1 && options.agents <= kMaxAgents, "agents must be in 1 … 10000",
        options.agents);
  check(options.episodes >= 1 && options.episodes <= kMaxEpisodes,
        "episodes must be in 1 … 1000000", options.episodes);
  check(options.horizon_s > 0.0 && std::isfinite(options.horizon_s),
        "horizon must be > 0 s and finite", options.horizon_s);
  CheckConditions(options.conditions, options.agents);
}

EvaluationResult ProtocolTimes(const StrategyContext& context, const EvaluationOptions& options) {
  EvaluationResult times;
  times.t_ref_s =
      context.closed_walk->length_m / TotalSpeed_mps(options.conditions, options.agents);
  const bool steady = options.protocol == Protocol::kSteady;
  times.warmup_s = steady ? kWarmupTref * times.t_ref_s : 0.0;
  times.window_s = steady ? kWindowTref * times.t_ref_s : options.horizon_s;
  return times;
}

bool EvaluateAll(std::span<const Evaluation> evaluations, int threads,
                 const EvaluationListener& listener, std::stop_token stop) {
  return PlayAll(evaluations, threads, listener, nullptr, stop);
}

std::optional<EvaluationResult> Evaluate(const StrategyContext& context,
                                         const StrategyFactory& make_strategy,
                                         const EvaluationOptions& options, TraceWriter* trace,
                                         std::stop_token stop) {
  const Evaluation evaluation{context, make_strategy, options};
  std::optional<EvaluationResult> result;
  const EvaluationListener listener{
      .on_episode = nullptr,
      .on_result = [&](std::size_t, EvaluationResult whole) { result = std::move(whole); }};
  PlayAll({&evaluation, 1}, trace != nullptr ? 1 : options.threads, listener, trace, stop);
  return result;
}

std::string_view ProtocolName(Protocol protocol) {
  return protocol == Protocol::kSteady ? "steady" : "thesis";
}

}  // namespace ronda
