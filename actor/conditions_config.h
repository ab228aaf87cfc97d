#pragma once
// [conditions] of the configuration: what a team is trained under, and judged under while it
// trains. Errors: InputError as run/config.h.
#include "common/run/config.h"
#include "common/world/conditions.h"

namespace ronda {

Conditions ReadConditions(Config& config, int robots);

}  // namespace ronda
