#include "deploy/training_evaluator.h"

#include <sys/resource.h>

#include <condition_variable>
#include <mutex>
#include <thread>

#include "common/evaluation/protocol.h"
#include "common/evaluation/report.h"
#include "common/run/log.h"
#include "common/team/policy_strategy.h"

namespace ronda {
namespace {

constexpr int kReportedEpisodes = 20;
constexpr std::uint64_t kReportedSeed = 1;

EvaluationOptions OptionsOf(const TrainingEvaluatorConfig& config, int episodes, std::uint64_t seed,
                            int threads) {
  EvaluationOptions options;
  options.episodes = episodes;
  options.seed = seed;
  options.agents = config.agents;
  options.conditions = config.conditions;
  options.threads = threads;
  return options;
}

}  // namespace

struct TrainingEvaluator::State {
  TrainingEvaluatorConfig config;
  StrategyContext context;
  WeightSource& weights;

  mutable std::mutex mutex;
  std::condition_variable_any changed;
  TrainingProgress progress = {};  // guarded by mutex, as all below
  bool finish = false;
  std::vector<PolicyEvaluation> evaluations;  // not taken yet
  std::optional<Yardstick> yardstick;
  std::optional<BestPolicy> best;

  std::jthread thread;  // last: it uses all of the above

  void Run(std::stop_token stop);
  void FindYardstick(std::stop_token stop);
  void EvaluateNewest(const TrainingProgress& at, std::stop_token stop);
};

TrainingEvaluator::TrainingEvaluator(const TrainingEvaluatorConfig& config,
                                     const StrategyContext& context, WeightSource& weights,
                                     const std::optional<BestPolicy>& best)
    : state_(new State{.config = config,
                       .context = context,
                       .weights = weights,
                       .mutex = {},
                       .changed = {},
                       .evaluations = {},
                       .yardstick = {},
                       .best = best,
                       .thread = {}}) {
  state_->thread = std::jthread([this](std::stop_token stop) { state_->Run(std::move(stop)); });
}

TrainingEvaluator::~TrainingEvaluator() = default;

void TrainingEvaluator::State::Run(std::stop_token stop) {
  setpriority(PRIO_PROCESS, 0, 10);  // this thread only (Linux)
  FindYardstick(stop);
  double next = config.step;
  while (!stop.stop_requested()) {
    TrainingProgress now;
    bool last = false;
    {
      std::unique_lock lock(mutex);
      changed.wait(lock, stop, [&] { return finish || progress.share >= next; });
      now = progress;
      last = finish;
    }
    if (stop.stop_requested()) return;
    next = now.share + config.step;
    EvaluateNewest(now, stop);
    if (last) return;
  }
}

void TrainingEvaluator::State::FindYardstick(std::stop_token stop) {
  const EvaluationOptions options = OptionsOf(config, kReportedEpisodes, kReportedSeed, 1);
  Yardstick found;
  found.bounds = BoundsOf(context, options);
  for (const std::string& name : AllStrategyNames()) {
    const auto result = Evaluate(
        context, [&] { return MakeStrategy(name, context); }, options, nullptr, stop);
    if (!result) return;
    const Estimate agi_s = MeanWithInterval(result->agi_s());
    if (found.strategy.empty() || agi_s.mean < found.agi_s.mean) {
      found.strategy = name;
      found.agi_s = agi_s;
    }
  }
  const std::lock_guard lock(mutex);
  yardstick = found;
}

void TrainingEvaluator::State::EvaluateNewest(const TrainingProgress& at, std::stop_token stop) {
  const WeightSnapshot* snapshot = weights.Newest();
  if (snapshot == nullptr || snapshot->updates == 0) return;
  PolicyFile policy = config.policy;
  policy.version = snapshot->version;
  policy.updates = snapshot->updates;
  policy.training.decisions = at.decisions;
  policy.training.training_s = at.training_s;
  policy.weights = snapshot->values;
  const auto result = Evaluate(
      context, [&] { return MakePolicyStrategy(policy, context); },
      OptionsOf(config, config.episodes, config.seed, 1), nullptr, stop);
  if (!result) return;
  const BestPolicy candidate{.agi_s = MeanWithInterval(result->agi_s()).mean,
                             .second_half = at.share >= 0.5};
  const std::lock_guard lock(mutex);
  evaluations.push_back(
      {.progress = at.share, .updates = policy.updates, .agi_s = candidate.agi_s});
  const bool better = !best || (candidate.second_half && !best->second_half) ||
                      (candidate.second_half == best->second_half && candidate.agi_s < best->agi_s);
  if (!better) return;
  try {
    WritePolicyFile(config.checkpoints / "best.ronda", policy);
    best = candidate;
  } catch (const std::exception& error) {
    LogWarning("the best policy could not be kept: {}", error.what());
  }
}

void TrainingEvaluator::set_progress(const TrainingProgress& progress) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->progress = progress;
  }
  state_->changed.notify_all();
}

std::vector<PolicyEvaluation> TrainingEvaluator::TakeNew() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->evaluations, {});
}

std::optional<Yardstick> TrainingEvaluator::yardstick() const {
  const std::lock_guard lock(state_->mutex);
  return state_->yardstick;
}

std::optional<BestPolicy> TrainingEvaluator::best() const {
  const std::lock_guard lock(state_->mutex);
  return state_->best;
}

void TrainingEvaluator::Finish(bool hurry) {
  if (hurry) {
    state_->thread.request_stop();
  } else {
    {
      const std::lock_guard lock(state_->mutex);
      state_->finish = true;
    }
    state_->changed.notify_all();
  }
  if (state_->thread.joinable()) state_->thread.join();
}

std::optional<Estimate> ReportedAgi(const PolicyFile& policy, const TrainingEvaluatorConfig& config,
                                    const StrategyContext& context, std::stop_token stop,
                                    std::chrono::milliseconds at_most) {
  std::stop_source give_up;
  const std::jthread clock([&](std::stop_token done) {
    const auto deadline = std::chrono::steady_clock::now() + at_most;
    while (!done.stop_requested() && !stop.stop_requested() &&
           std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    give_up.request_stop();
  });
  const auto result = Evaluate(
      context, [&] { return MakePolicyStrategy(policy, context); },
      OptionsOf(config, kReportedEpisodes, kReportedSeed, 0), nullptr, give_up.get_token());
  if (!result) return std::nullopt;
  return MeanWithInterval(result->agi_s());
}

}  // namespace ronda
