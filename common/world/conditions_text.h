#pragma once
// The conditions as texts: what options of commands and keys of a configuration say.
//
// Each condition takes one text; "none" means its default. A value of several parts has them
// separated by "/": speeds "1/0.5" (the robots take them in turn), failures "3@600/5@900" (robot 3
// at 600 s from the episode's start), priorities "12=5/7=3" (vertex 12 counts five times one of
// priority 1). Texts that are none of these throw UsageError with condition, rule and text; ranges
// are CheckConditions' matter.
#include <span>
#include <string>

#include "common/world/conditions.h"

namespace ronda {

struct ConditionOption {
  const char* name;  // as an option: "message-loss"
  const char* doc;
  void (*set)(Conditions& conditions, const std::string& text);
};

/// All conditions, in the order in which labels and tables name them.
std::span<const ConditionOption> ConditionOptions();

/// Sets one condition from its text; `name` is one of ConditionOptions', else a bug.
void SetCondition(Conditions& conditions, const std::string& name, const std::string& text);

}  // namespace ronda
