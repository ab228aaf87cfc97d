#include "common/run/duration.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "common/base/check.h"
#include "common/base/error.h"

namespace ronda {
namespace {

std::optional<double> SecondsInUnit(std::string_view unit) {
  if (unit == "ms") return 1e-3;
  if (unit == "s" || unit.empty()) return 1.0;
  if (unit == "m") return 60.0;
  if (unit == "h") return 3600.0;
  return std::nullopt;
}

}  // namespace

double ParseDuration(const std::string& text, const std::string& option) {
  double count = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, count, std::chars_format::fixed);
  const auto unit_s = SecondsInUnit(std::string_view(rest, static_cast<std::size_t>(end - rest)));
  const double duration_s = count * unit_s.value_or(0.0);
  if (error != std::errc() || !std::isfinite(duration_s) || !(duration_s > 0.0)) {
    throw UsageError(
        fmt::format("{}: must be a duration above 0, such as 90s, 2m, 1.5h or 250ms, got {}",
                    option, text.empty() ? "nothing" : text));
  }
  return duration_s;
}

std::string FormatDuration(double duration_s) {
  RONDA_CHECK(std::isfinite(duration_s) && duration_s >= 0.0, "duration {} s", duration_s);
  if (duration_s < 9.95) return fmt::format("{:.1f} s", duration_s);
  const auto whole_s = static_cast<long long>(std::round(duration_s));
  if (whole_s < 120) return fmt::format("{} s", whole_s);
  if (whole_s < 7200) return fmt::format("{} min {} s", whole_s / 60, whole_s % 60);
  const long long whole_min = (whole_s + 30) / 60;
  return fmt::format("{} h {} min", whole_min / 60, whole_min % 60);
}

}  // namespace ronda
