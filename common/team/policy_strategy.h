#pragma once
// A trained network as a strategy: encodes what the arrived robot sees and takes the best action.
//
// A scorer of candidates fits every map and team; a network of another kind fits maps of the size
// it was trained on, else InputError, as for an observation that this program does not know; one
// that observes the agent-vertex matrix fits teams of the size it was trained with, else InputError
// at the beginning of an episode. Errors from a file name it: CheckpointError as
// policies/policy_file. Thread-compatible.
#include <filesystem>
#include <memory>

#include "common/policies/policy_file.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

std::unique_ptr<Strategy> MakePolicyStrategy(const PolicyFile& policy,
                                             const StrategyContext& context);
std::unique_ptr<Strategy> LoadPolicyStrategy(const std::filesystem::path& policy_file,
                                             const StrategyContext& context);

}  // namespace ronda
