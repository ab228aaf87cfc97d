#pragma once
// Figures of a status as people read them. Any value is fine, also what a file may have wrong: what
// makes no sense is "–". Pure.
#include <optional>
#include <string>

namespace ronda {

/// Three digits and a decimal prefix: "0", "2.5", "310", "21.0 k", "1.23 M". Values ≥ 0.
std::string Short(double value);
/// "1.23 MB".
std::string ShortBytes(double bytes);
/// As FormatDuration: "3 min 20 s".
std::string ShortDuration(double duration_s);
/// "12.95", in seconds.
std::string Hundredths(const std::optional<double>& value);
/// " 42 %"; 0 … 1, else the nearer of the two.
std::string Percent(double share);
/// "13:05:59" of the day, `utc_offset_s` ahead of UTC.
std::string ClockTime(double unix_s, int utc_offset_s);

}  // namespace ronda
