#pragma once
// A trained network on disk: what it is, how it was trained, and its weights.
//
// Inside a checked file (base/checked_file.h, magic "RONDAPOL") a cereal portable binary archive,
// the same bytes on every machine. Errors: CheckpointError naming file, rule and value, for
// whatever cannot be read, is foreign, torn, newer, inconsistent or not finite. Reading allocates
// no more than a small multiple of the file's length.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/nn/network_spec.h"

namespace ronda {

struct PolicyFile {
  NetworkSpec spec;
  std::string map;       // name of the map that it was trained on
  int agents = 0;        // number of robots that it was trained with; 0: several
  std::string training;  // free text: command, seed, …
  std::uint64_t version = 0;
  std::uint64_t updates = 0;
  double discount_horizon_s = 0.0;  // −1/ln γ; 0: not given in time
  std::vector<float> weights;       // (P)
  friend bool operator==(const PolicyFile&, const PolicyFile&) = default;
};

void WritePolicyFile(const std::filesystem::path& path, const PolicyFile& policy);
PolicyFile ReadPolicyFile(const std::filesystem::path& path);

}  // namespace ronda
