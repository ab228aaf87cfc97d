#pragma once
// What an encoder writes for a robot, into memory that held other values before.
#include <cstdint>
#include <vector>

#include "common/environments/observation_encoder.h"
#include "common/world/team_beliefs.h"

namespace ronda::testing {

struct Observation {
  std::vector<float> values;
  std::vector<std::uint8_t> legal;
};

inline Observation Encode(ObservationEncoder& encoder, const PatrolWorld& world, int robot) {
  // Filled with what must be overwritten.
  Observation observation{.values = std::vector<float>(encoder.observation_size(), 99.0f),
                          .legal = std::vector<std::uint8_t>(encoder.num_actions(), 7)};
  encoder.Encode(CompleteBelief(world, robot), observation.values, observation.legal);
  return observation;
}

}  // namespace ronda::testing
