#include "common/evaluation/policy_strategy.h"

#include <fmt/format.h>

#include "common/base/error.h"

namespace ronda {

std::unique_ptr<Strategy> MakePolicyStrategy(const std::string& policy,
                                             const StrategyContext& /*context*/) {
  throw InputError(fmt::format("no policy is called '{}'", policy));
}

}  // namespace ronda
