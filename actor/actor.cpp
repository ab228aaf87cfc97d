#include "actor/actor.h"

#include <algorithm>

namespace ronda {
namespace {

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
  return Epsilon(options_.exploration, progress_, options_.index, options_.actors);
}

int Actor::Step() {
  sink_.Poll();
  if (!EmptyOutbox()) {
    ++counters_.throttled;
    return 0;
  }
  LoadNewestWeights();
  if (!in_episode_) BeginEpisode();

  const Decision& decision = environment_.decision();
  const int agent = decision.agent;
  const int action = Choose(decision);
  adder_.Choose(agent, action, counters_.weights_version);
  const StepOutcome outcome = environment_.Step(action);
  for (const SettledReward& settled : outcome.settled) adder_.Settle(settled);
  if (outcome.state == EpisodeState::kRunning) {
    adder_.Observe(environment_.decision());
  } else {
    adder_.Finish(outcome.state, environment_.decision());
    counters_.dropped = adder_.dropped();
    in_episode_ = false;
    ++counters_.episodes;
  }
  ++counters_.decisions;
  EmptyOutbox();
  return 1;
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
    ++counters_.transitions;
  }
  return !closed_;
}

void Actor::LoadNewestWeights() {
  const WeightSnapshot* const newest = weights_.Newest();
  if (newest == nullptr) return;
  if (policy_.Load(*newest) == LoadResult::kLoaded) {
    has_weights_ = true;
    counters_.weights_version = newest->version;
  } else {
    ++counters_.weights_refused;
  }
}

void Actor::BeginEpisode() {
  environment_.Reset(SplitSeed(episode_seed_, counters_.episodes));
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
