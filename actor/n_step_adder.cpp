#include "actor/n_step_adder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {

NStepAdder::NStepAdder(const EnvironmentSpec& spec, int n)
    : spec_(spec),
      n_(static_cast<std::size_t>(n)),
      agents_(static_cast<std::size_t>(spec.num_agents)) {
  if (n < 1) throw InputError(fmt::format("actor.n_step: must be ≥ 1, got {}", n));
}

void NStepAdder::Observe(const Decision& decision) {
  Agent& agent = agents_[decision.agent];
  const std::uint64_t expected = agent.first_index + agent.steps.size();
  RONDA_CHECK(decision.index == expected, "agent {}: decision {} where {} is next", decision.agent,
              decision.index, expected);
  RONDA_CHECK(agent.steps.empty() || agent.steps.back().action >= 0,
              "agent {}: observed twice before decision {}", decision.agent, decision.index);
  Step step;
  step.observation.assign(decision.observation.begin(), decision.observation.end());
  step.legal.assign(decision.legal_actions.begin(), decision.legal_actions.end());
  step.discount = decision.discount;
  agent.steps.push_back(std::move(step));
  Complete(decision.agent);
}

void NStepAdder::Choose(int agent, int action, std::uint64_t weights_version) {
  auto& steps = agents_[agent].steps;
  RONDA_CHECK(!steps.empty() && steps.back().action < 0, "agent {} chose without an observation",
              agent);
  steps.back().action = action;
  steps.back().weights_version = weights_version;
}

void NStepAdder::Settle(const SettledReward& settled) {
  Agent& agent = agents_[settled.agent];
  const std::uint64_t position = settled.index - agent.first_index;
  RONDA_CHECK(settled.index >= agent.first_index && position < agent.steps.size(),
              "agent {}: reward for decision {}, but {} … {} wait", settled.agent, settled.index,
              agent.first_index, agent.first_index + agent.steps.size());
  Step& step = agent.steps[position];
  RONDA_CHECK(step.action >= 0 && !step.settled, "agent {}: decision {} settled {}", settled.agent,
              settled.index, step.settled ? "twice" : "before it was made");
  step.reward = settled.reward;
  step.settled = true;
  Complete(settled.agent);
}

void NStepAdder::Finish(EpisodeState state, const Decision& last) {
  RONDA_CHECK(state != EpisodeState::kRunning, "the episode has not ended");
  if (state == EpisodeState::kCut) Observe(last);
  for (int agent = 0; agent < spec_.num_agents; ++agent) Flush(agent, state);
}

std::size_t NStepAdder::SettledAhead(const Agent& agent, std::size_t at_most) {
  std::size_t count = 0;
  while (count < at_most && count < agent.steps.size() && agent.steps[count].settled) ++count;
  return count;
}

void NStepAdder::Complete(int agent) {
  const Agent& state = agents_[agent];
  while (state.steps.size() > n_ && SettledAhead(state, n_) == n_) Emit(agent, n_, false);
}

void NStepAdder::Flush(int agent, EpisodeState state) {
  Agent& of = agents_[agent];
  while (!of.steps.empty()) {
    const std::size_t left = of.steps.size();
    const bool terminal = state == EpisodeState::kTerminal;
    // At a cut the last step only lends its observation: nothing follows it.
    const std::size_t settled = SettledAhead(of, std::min(n_, terminal ? left : left - 1));
    if (terminal && settled == left) {
      Emit(agent, settled, true);
    } else if (settled == n_ || (!terminal && settled > 0)) {
      Emit(agent, settled, false);
    } else {
      if (of.steps.front().action >= 0) ++dropped_;  // what was only observed was no decision
      of.steps.pop_front();
    }
  }
  of.first_index = 0;
}

void NStepAdder::Emit(int agent, std::size_t steps, bool terminal) {
  Agent& of = agents_[agent];
  Transition transition;
  float weight = 1.0f;
  for (std::size_t j = 0; j < steps; ++j) {
    transition.reward += weight * of.steps[j].reward;
    if (j + 1 < of.steps.size()) weight *= of.steps[j + 1].discount;
  }
  Step& first = of.steps.front();
  transition.action = first.action;
  transition.agent = static_cast<std::uint32_t>(agent);
  transition.weights_version = first.weights_version;
  if (terminal) {
    transition.discount = 0.0f;
    transition.next_observation.assign(static_cast<std::size_t>(spec_.observation_size), 0.0f);
    transition.next_legal_actions.assign(static_cast<std::size_t>(spec_.num_actions), 0);
    transition.next_legal_actions.front() = 1;  // any: its value counts 0 times
  } else {
    transition.discount = weight;
    transition.next_observation = of.steps[steps].observation;
    transition.next_legal_actions = of.steps[steps].legal;
  }
  transition.observation = std::move(first.observation);
  completed_.push_back(std::move(transition));
  of.steps.pop_front();
  ++of.first_index;
}

}  // namespace ronda
