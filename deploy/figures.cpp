#include "deploy/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/run/duration.h"

namespace ronda {
namespace {

constexpr const char* kNone = "–";
constexpr double kLongest_s = 1e9;
constexpr double kLatest_s = 1e12;
constexpr long long kDay_s = 86'400;

std::string WithPrefix(double value, const std::string& unit) {
  constexpr std::array<const char*, 5> kPrefixes{"", "k", "M", "G", "T"};
  if (!std::isfinite(value) || value < 0.0) return kNone;
  std::size_t prefix = 0;
  while (value >= 999.5 && prefix + 1 < kPrefixes.size()) {
    value /= 1000.0;
    ++prefix;
  }
  const bool whole = prefix == 0 && value == std::round(value);
  const int decimals = whole || value >= 99.95 ? 0 : value >= 9.995 || prefix == 0 ? 1 : 2;
  if (value >= 1e6) return kNone;
  const std::string full_unit = kPrefixes[prefix] + unit;
  return fmt::format("{:.{}f}{}{}", value, decimals, full_unit.empty() ? "" : " ", full_unit);
}

}  // namespace

std::string Short(double value) { return WithPrefix(value, ""); }

std::string ShortBytes(double bytes) { return WithPrefix(bytes, "B"); }

std::string ShortDuration(double duration_s) {
  return duration_s >= 0.0 && duration_s < kLongest_s ? FormatDuration(duration_s) : kNone;
}

std::string Hundredths(const std::optional<double>& value) {
  return value && std::abs(*value) < 1e9 ? fmt::format("{:.2f}", *value) : kNone;
}

std::string Percent(double share) {
  const double within = share > 0.0 ? std::min(share, 1.0) : 0.0;
  return fmt::format("{:3.0f} %", 100.0 * within);
}

std::string ClockTime(double unix_s, int utc_offset_s) {
  if (!(std::abs(unix_s) < kLatest_s)) return kNone;
  const auto local_s = static_cast<long long>(std::floor(unix_s)) + utc_offset_s;
  const long long s = (local_s % kDay_s + kDay_s) % kDay_s;
  return fmt::format("{:02}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace ronda
