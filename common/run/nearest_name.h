#pragma once
// The known name that a mistyped one most likely meant: least Damerau-Levenshtein distance (optimal
// string alignment: insert, delete, replace or swap two neighbours, 1 each); the first among
// equals. A name that differs by leading sections only (a.b for b, or b for a.b) goes before all.
// Pure. O(length²) for each known name. Source: Damerau 1964.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ronda {

int EditDistance(std::string_view a, std::string_view b);

/// nullopt where nothing is known.
std::optional<std::string> NearestName(std::string_view name,
                                       const std::vector<std::string>& known);

}  // namespace ronda
