#pragma once
// The part of the configuration that every process of a run reads: [run], [interface], [network],
// [dds] and what replay and learner agree on.
//
// [interface] holds what follows from the map, the environment and the observation; the launcher
// works it out and writes it down, so replay and learner need to know no environment. Errors:
// InputError as config.h.
#include <cstdint>
#include <string>
#include <vector>

#include "common/rl/transition.h"
#include "common/run/config.h"

namespace ronda {

inline constexpr int kMaxActors = 90;  // with the others, as many as find each other in a domain

struct RunConfig {
  std::string map;
  std::string length;  // euclidean | file: where edge lengths come from
  int agents = 10;
  int actors = 1;
  std::string algorithm;
  std::uint64_t seed = 1;
  double budget_s = 0.0;               // training time of the run folder; 0: no limit
  std::uint64_t budget_decisions = 0;  // of the run folder; 0: no limit
  TransitionShape shape;
  int features = 0;        // of one candidate, where the observation is made of candidates; else 0
  std::string schema;      // name of the observation
  double speed_mps = 0.0;  // of every robot; this and the next two are facts for the policy's file
  std::string reward;
  double discount_horizon_s = 0.0;
  std::vector<int> hidden_sizes;
  bool layer_norm = false;
  std::uint32_t batch_size = 128;  // what replay and learner agree on
  bool prioritised = false;        // mini-batches by priority
  int socket_buffer_bytes = 0;
};

RunConfig ReadRunConfig(Config& config);

}  // namespace ronda
