#pragma once
// A trained network as a strategy: encodes what the arrived robot sees and takes the best action.
//
// A scorer of candidates fits every map and team; a network of another kind fits maps of the size
// it was trained on, else InputError. Errors from a file: CheckpointError as policies/policy_file.
// Thread-compatible.
#include <filesystem>
#include <memory>
#include <string>

#include "common/policies/policy_file.h"
#include "common/world/strategies/strategy.h"

namespace ronda {

/// The file that a `--policy` names: a policy file; a run folder (its best policy; `DIR@latest` its
/// latest); or the name of a policy that ships. InputError where there is none.
std::filesystem::path FindPolicyFile(const std::string& policy);

std::unique_ptr<Strategy> MakePolicyStrategy(const PolicyFile& policy,
                                             const StrategyContext& context);

inline std::unique_ptr<Strategy> MakePolicyStrategy(const std::string& policy,
                                                    const StrategyContext& context) {
  return MakePolicyStrategy(ReadPolicyFile(FindPolicyFile(policy)), context);
}

}  // namespace ronda
