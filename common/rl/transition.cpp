#include "common/rl/transition.h"

#include "common/base/check.h"

namespace ronda {

void TransitionBatch::Append(const Transition& transition) {
  RONDA_CHECK(transition.observation.size() == shape.observation_size &&
                  transition.next_observation.size() == shape.observation_size &&
                  transition.next_legal_actions.size() == shape.num_actions &&
                  transition.extras.size() == shape.extras_size,
              "a transition of {}/{}/{}/{} floats for a batch of {}/{}/{}",
              transition.observation.size(), transition.next_observation.size(),
              transition.next_legal_actions.size(), transition.extras.size(),
              shape.observation_size, shape.num_actions, shape.extras_size);
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(observations, transition.observation);
  actions.push_back(transition.action);
  rewards.push_back(transition.reward);
  discounts.push_back(transition.discount);
  append(next_observations, transition.next_observation);
  append(next_legal_actions, transition.next_legal_actions);
  append(extras, transition.extras);
  agents.push_back(transition.agent);
  weights_versions.push_back(transition.weights_version);
  ++count;
}

void TransitionBatch::Clear() {
  count = 0;
  observations.clear();
  actions.clear();
  rewards.clear();
  discounts.clear();
  next_observations.clear();
  next_legal_actions.clear();
  extras.clear();
  agents.clear();
  weights_versions.clear();
}

}  // namespace ronda
