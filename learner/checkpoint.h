#pragma once
// The learner's checkpoint: everything that a restart needs, in one checked file
// (base/checked_file.h), magic "RONDALRN".
//
// Written to `learner.checkpoint`; the one before stays as `learner.previous`. Reading takes the
// newest that is whole, and says in `note` why it passed one over. CheckpointError where one cannot
// be written, or there are only broken ones.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "learner/algorithm.h"

namespace ronda {

struct LearnerCheckpoint {
  AlgorithmState algorithm;
  std::uint64_t weights_version = 0;
};

void WriteLearnerCheckpoint(const std::filesystem::path& folder,
                            const LearnerCheckpoint& checkpoint);

/// nullopt where the folder has none.
std::optional<LearnerCheckpoint> ReadLearnerCheckpoint(const std::filesystem::path& folder,
                                                       std::string& note);

}  // namespace ronda
