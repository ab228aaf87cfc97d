#include "common/run/duration.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "common/base/error.h"

namespace ronda {

double ParseDuration(const std::string& text, const std::string& option) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string unit(end, text.data() + text.size());
  double scale = 0.0;
  if (unit.empty() || unit == "s") scale = 1.0;
  if (unit == "ms") scale = 0.001;
  if (unit == "m" || unit == "min") scale = 60.0;
  if (unit == "h") scale = 3600.0;
  const double seconds = number * scale;
  if (error != std::errc() || !std::isfinite(seconds) || !(seconds > 0.0)) {
    throw UsageError(fmt::format(
        "{}: must be a duration above 0 such as 90s, 2m, 1.5h or 250ms, got '{}'", option, text));
  }
  return seconds;
}

std::string FormatDuration(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace ronda
