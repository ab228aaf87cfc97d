#include "actor/actor.h"

#include <algorithm>
#include <chrono>

namespace ronda {
namespace {

constexpr std::chrono::milliseconds kLongestWait{50};  // so that a stop is seen soon

int RandomLegalAction(std::span<const std::uint8_t> legal_actions, Rng& rng) {
  const auto legal =
      static_cast<std::uint32_t>(std::count(legal_actions.begin(), legal_actions.end(), 1));
  std::uint32_t skip = rng.Below(legal);
  int action = 0;
  while (legal_actions[action] != 1 || skip-- > 0) ++action;
  return action;
}

}  // namespace

Actor::Actor(Environment& environment, Policy& policy, TransitionSink& sink, WeightSource& weights,
             const ActorOptions& options)
    : environment_(environment),
      policy_(policy),
      sink_(sink),
      weights_(weights),
      options_(options),
      adder_(environment.spec(), options.n_step),
      episode_seed_(SplitSeed(options.seed, 2 * static_cast<std::uint64_t>(options.index))()),
      exploration_rng_(SplitSeed(options.seed, 2 * static_cast<std::uint64_t>(options.index) + 1)) {
  CheckExploration(options.exploration);
}

double Actor::epsilon() const {
  return Epsilon(options_.exploration, progress_.load(std::memory_order_relaxed), options_.index,
                 options_.actors);
}

ActorCounters Actor::counters() const {
  return {.decisions = decisions_,
          .episodes = episodes_,
          .transitions = transitions_,
          .dropped = dropped_,
          .throttled = throttled_,
          .weights_version = weights_version_,
          .weights_refused = weights_refused_};
}

int Actor::Step() {
  sink_.Poll();
  if (!EmptyOutbox()) {
    ++throttled_;
    return 0;
  }
  LoadNewestWeights();
  if (!in_episode_) BeginEpisode();

  const Decision& decision = environment_.decision();
  const int agent = decision.agent;
  const int action = Choose(decision);
  adder_.Choose(agent, action, weights_version_);
  const StepOutcome outcome = environment_.Step(action);
  for (const SettledReward& settled : outcome.settled) adder_.Settle(settled);
  if (outcome.state == EpisodeState::kRunning) {
    adder_.Observe(environment_.decision());
  } else {
    adder_.Finish(outcome.state, environment_.decision());
    dropped_ = adder_.dropped();
    in_episode_ = false;
    ++episodes_;
  }
  ++decisions_;
  EmptyOutbox();
  return 1;
}

void Actor::Run(const std::stop_token& stop) {
  while (!stop.stop_requested() && !closed_) {
    if (Step() == 0 && !closed_) sink_.Wait(kLongestWait);
  }
}

bool Actor::EmptyOutbox() {
  auto& outbox = adder_.completed();
  while (!outbox.empty() && !closed_) {
    const PushResult result = sink_.Push(outbox.front());
    if (result == PushResult::kThrottled) return false;
    if (result == PushResult::kClosed) {
      closed_ = true;
      break;
    }
    outbox.pop_front();
    ++transitions_;
  }
  return !closed_;
}

void Actor::LoadNewestWeights() {
  const WeightSnapshot* const newest = weights_.Newest();
  if (newest == nullptr) return;
  if (policy_.Load(*newest) == LoadResult::kLoaded) {
    has_weights_ = true;
    weights_version_ = newest->version;
  } else {
    ++weights_refused_;
  }
}

void Actor::BeginEpisode() {
  environment_.Reset(SplitSeed(episode_seed_, episodes_));
  adder_.Observe(environment_.decision());
  in_episode_ = true;
}

int Actor::Choose(const Decision& decision) {
  if (!has_weights_ || exploration_rng_.Uniform() < epsilon()) {
    return RandomLegalAction(decision.legal_actions, exploration_rng_);
  }
  return policy_.Act(decision.observation, decision.legal_actions);
}

}  // namespace ronda
