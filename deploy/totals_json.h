#pragma once
// The JSON form of a run's totals and of optional values: each field by its name; nothing is null.
#include <nlohmann/json.hpp>
#include <optional>

#include "deploy/transition_ledger.h"

namespace nlohmann {

template <typename Value>
struct adl_serializer<std::optional<Value>> {
  static void to_json(json& to, const std::optional<Value>& value) {
    to = value ? json(*value) : json(nullptr);
  }
  static void from_json(const json& from, std::optional<Value>& value) {
    value.reset();
    if (!from.is_null()) value = from.get<Value>();
  }
};

}  // namespace nlohmann

namespace ronda {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunTotals, decisions, sent, stored, in_flight, lost, doubled,
                                   forgotten, messages_refused, weights_version)

}  // namespace ronda
