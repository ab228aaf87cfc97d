#pragma once
// Durations as people write and read them. Pure.
#include <string>

namespace ronda {

/// Seconds, finite and > 0: "90s", "2m", "1.5h", "250ms"; a bare number is seconds. Else UsageError
/// that names `option`, rule and value.
double ParseDuration(const std::string& text, const std::string& option);

/// "0.4 s", "85 s", "3 min 20 s", "2 h 5 min"; `duration_s` finite and ≥ 0.
std::string FormatDuration(double duration_s);

}  // namespace ronda
