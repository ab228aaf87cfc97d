#pragma once
// A trained network on disk: what it is, how it was trained, and its weights.
//
// Inside a checked file (base/checked_file.h, magic "RONDAPOL") a cereal portable binary archive,
// the same bytes on every machine; fields and versions: docs/policies.md. Formats 1 and 2 are read,
// 2 is written. Errors: CheckpointError naming file, rule and value, for whatever cannot be read,
// is foreign, torn, newer, inconsistent or not finite. Reading allocates no more than a small
// multiple of the file's length.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/nn/network_spec.h"

namespace ronda {

/// The format that WritePolicyFile writes, and the newest that ReadPolicyFile reads.
inline constexpr std::uint32_t kPolicyFormat = 2;

/// Where a policy comes from. Empty and 0: not known, unless said otherwise. Texts are for people:
/// at most 1024 bytes, no control characters.
struct TrainingFacts {
  std::string map = {};    // name of the map that it was trained on
  int agents = 0;          // number of robots that it was trained with; 0: several
  double speed_mps = 0.0;  // of every robot; 0: they differ
  std::string algorithm = {};
  std::int64_t seed = -1;  // −1: not known
  std::string reward = {};
  double discount_horizon_s = 0.0;  // −1/ln γ
  std::uint64_t decisions = 0;      // of all robots and actors
  double training_s = 0.0;
  double agi_s = 0.0;       // as judged after training: steady protocol, 20 episodes of seed 1
  double agi_ci95_s = 0.0;  // half width of its 95 % interval
  std::string ronda_version = {};
  friend bool operator==(const TrainingFacts&, const TrainingFacts&) = default;
};

struct PolicyFile {
  NetworkSpec spec;
  TrainingFacts training;
  std::uint64_t version = 0;  // of the weights, within the run
  std::uint64_t updates = 0;
  std::vector<float> weights;            // (P)
  std::uint32_t format = kPolicyFormat;  // of the file that it was read from
  friend bool operator==(const PolicyFile&, const PolicyFile&) = default;
};

void WritePolicyFile(const std::filesystem::path& path, const PolicyFile& policy);
PolicyFile ReadPolicyFile(const std::filesystem::path& path);

}  // namespace ronda
