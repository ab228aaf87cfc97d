#pragma once
// Durations as people write them: 90s, 2m, 1.5h, 250ms; a bare number is seconds.
#include <string>

namespace ronda {

/// Seconds, > 0 and finite; else UsageError that names `option`, rule and value.
double ParseDuration(const std::string& text, const std::string& option);

/// For people: "0.4 s", "85 s", "3 min 20 s", "2 h 5 min".
std::string FormatDuration(double seconds);

}  // namespace ronda
