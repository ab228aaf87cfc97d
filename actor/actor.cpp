#include "actor/actor.h"

namespace ronda {

Actor::Actor(Environment& environment, Policy& policy, TransitionSink& sink, WeightSource& weights,
             const ActorOptions& options)
    : environment_(environment),
      policy_(policy),
      sink_(sink),
      weights_(weights),
      options_(options),
      rng_(SplitSeed(SplitSeed(options.seed, options.index)(), options.incarnation)),
      adder_(environment.spec(), options.n_steps) {
  BeginEpisode();
}

int Actor::Step() {
  if (!EmptyOutbox()) return 0;
  LoadNewestWeights();
  const int action = ChooseAction(environment_.decision());
  adder_.Decide(environment_.decision(), action, weights_version_);
  const StepOutcome outcome = environment_.Step(action);
  ++decisions_;
  adder_.Settle(outcome.settled);
  if (outcome.state != EpisodeState::kRunning) {
    if (outcome.state == EpisodeState::kCut) adder_.Observe(environment_.decision());
    adder_.EndEpisode(outcome.state);
    BeginEpisode();
  }
  return 1;
}

bool Actor::EmptyOutbox() {
  auto& outbox = adder_.completed();
  while (!outbox.empty()) {
    if (sink_.Push(outbox.front()) != PushResult::kAccepted) return false;
    outbox.pop_front();
  }
  return true;
}

void Actor::LoadNewestWeights() {
  const WeightSnapshot* snapshot = weights_.Newest();
  if (snapshot == nullptr) return;
  if (policy_.Load(*snapshot) == LoadResult::kLoaded) {
    weights_version_ = snapshot->version;
  } else {
    ++weights_refused_;
  }
}

int Actor::ChooseAction(const Decision& decision) {
  if (weights_version_ > 0 && rng_.Uniform() >= epsilon()) {
    return policy_.Act(decision.observation, decision.legal_actions);
  }
  std::uint32_t legal = 0;
  for (const std::uint8_t one : decision.legal_actions) legal += one;
  std::uint32_t chosen = rng_.Below(legal);
  int action = 0;
  while (decision.legal_actions[action] == 0 || chosen-- > 0) ++action;
  return action;
}

void Actor::BeginEpisode() {
  environment_.Reset(SplitSeed(rng_(), episodes_));
  ++episodes_;
}

double Actor::epsilon() const {
  return Epsilon(options_.exploration, progress_, options_.index, options_.actors);
}

}  // namespace ronda
