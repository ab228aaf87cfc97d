#include "actor/n_step_adder.h"

#include <algorithm>

#include "common/base/check.h"

namespace ronda {

NStepAdder::NStepAdder(const EnvironmentSpec& spec, int n_steps)
    : spec_(spec),
      n_steps_(static_cast<std::size_t>(n_steps)),
      steps_(static_cast<std::size_t>(spec.num_agents)) {
  RONDA_CHECK(n_steps >= 1, "n = {}", n_steps);
}

void NStepAdder::Append(const Decision& decision, int action, std::uint64_t weights_version) {
  auto& steps = steps_[decision.agent];
  if (!steps.empty()) steps.back().discount = decision.discount;
  steps.push_back({.index = decision.index,
                   .observation = {decision.observation.begin(), decision.observation.end()},
                   .legal_actions = {decision.legal_actions.begin(), decision.legal_actions.end()},
                   .action = action,
                   .weights_version = weights_version});
  Emit(decision.agent);
}

void NStepAdder::Decide(const Decision& decision, int action, std::uint64_t weights_version) {
  RONDA_CHECK(action >= 0, "action {}", action);
  Append(decision, action, weights_version);
}

void NStepAdder::Observe(const Decision& decision) { Append(decision, -1, 0); }

void NStepAdder::Settle(std::span<const SettledReward> settled) {
  for (const SettledReward& one : settled) {
    auto& steps = steps_[one.agent];
    RONDA_CHECK(!steps.empty() && one.index >= steps.front().index &&
                    one.index - steps.front().index < steps.size(),
                "agent {} has no open decision {}", one.agent, one.index);
    Step& step = steps[static_cast<std::size_t>(one.index - steps.front().index)];
    RONDA_CHECK(!step.settled, "decision {} of agent {} is settled twice", one.index, one.agent);
    step.reward = one.reward;
    step.settled = true;
    Emit(one.agent);
  }
}

void NStepAdder::Emit(int agent) {
  auto& steps = steps_[agent];
  while (steps.size() > n_steps_) {
    for (std::size_t j = 0; j < n_steps_; ++j) {
      if (!steps[j].settled) return;
    }
    completed_.push_back(Complete(steps, static_cast<std::uint32_t>(agent), n_steps_));
    steps.pop_front();
  }
}

Transition NStepAdder::Complete(const std::deque<Step>& steps, std::uint32_t agent,
                                std::size_t length) const {
  const Step& first = steps.front();
  Transition transition{.observation = first.observation,
                        .action = first.action,
                        .reward = 0.0f,
                        .discount = 1.0f,
                        .next_observation = {},
                        .next_legal_actions = {},
                        .extras = {},
                        .agent = agent,
                        .weights_version = first.weights_version};
  for (std::size_t j = 0; j < length; ++j) {
    transition.reward += transition.discount * steps[j].reward;
    transition.discount *= steps[j].discount;
  }
  if (length < steps.size()) {
    transition.next_observation = steps[length].observation;
    transition.next_legal_actions = steps[length].legal_actions;
  } else {
    transition.discount = 0.0f;
    transition.next_observation.assign(static_cast<std::size_t>(spec_.observation_size), 0.0f);
    transition.next_legal_actions.assign(static_cast<std::size_t>(spec_.num_actions), 1);
  }
  return transition;
}

void NStepAdder::EndEpisode(EpisodeState state) {
  for (std::size_t agent = 0; agent < steps_.size(); ++agent) {
    auto& steps = steps_[agent];
    while (!steps.empty()) {
      std::size_t length = 0;
      while (length < std::min(n_steps_, steps.size()) && steps[length].settled) ++length;
      // At a cut the bootstrap needs an observation after the last step that counts.
      if (state == EpisodeState::kCut) length = std::min(length, steps.size() - 1);
      if (length > 0) {
        completed_.push_back(Complete(steps, static_cast<std::uint32_t>(agent), length));
      }
      steps.pop_front();
    }
  }
}

}  // namespace ronda
