#pragma once
// A trained policy as a strategy: what a run, a policy file or a shipped policy's name decides on
// arrival.
#include <memory>
#include <string>

#include "common/world/strategies/strategy.h"

namespace ronda {

/// `policy` is a run folder, a policy file or the name of a policy that ships. Throws InputError
/// when there is none or it does not fit the map.
std::unique_ptr<Strategy> MakePolicyStrategy(const std::string& policy,
                                             const StrategyContext& context);

}  // namespace ronda
