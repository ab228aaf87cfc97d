#include "deploy/value_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "common/base/error.h"

namespace ronda {
namespace {

constexpr std::string_view kRange = "..";

[[noreturn]] void Refuse(const std::string& option, const std::string& rule,
                         const std::string& text) {
  throw UsageError(fmt::format("{} must be {}, got '{}'", option, rule, text));
}

/// nullopt where the text is anything else or more.
std::optional<int> Parse(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

template <typename Value>
void AddOnce(std::vector<Value>& values, const Value& value) {
  if (std::ranges::find(values, value) == values.end()) values.push_back(value);
}

struct Range {
  int first = 0;
  int last = 0;
  int step = 1;
};

std::optional<Range> ParseRange(std::string_view text) {
  const auto dots = text.find(kRange);
  if (dots == std::string_view::npos) {
    const auto number = Parse(text);
    return number ? std::optional(Range{*number, *number, 1}) : std::nullopt;
  }
  const std::string_view rest = text.substr(dots + kRange.size());
  const auto colon = rest.find(':');
  const auto first = Parse(text.substr(0, dots));
  const auto last = Parse(rest.substr(0, colon));
  const auto step = colon == rest.npos ? std::optional(1) : Parse(rest.substr(colon + 1));
  if (!first || !last || !step || *first > *last || *step < 1) return std::nullopt;
  return Range{*first, *last, *step};
}

}  // namespace

std::vector<int> ParseWholeNumbers(const std::string& option, const std::vector<std::string>& texts,
                                   int least, int greatest) {
  std::vector<int> numbers;
  for (const std::string& text : texts) {
    const auto range = ParseRange(text);
    if (!range || range->first < least || range->last > greatest) {
      Refuse(option,
             fmt::format("whole numbers in {} … {}, or ranges of them such as 2..12 or 2..12:2",
                         least, greatest),
             text);
    }
    for (int number = range->first;; number += range->step) {
      AddOnce(numbers, number);
      if (range->last - number < range->step) break;
    }
  }
  return numbers;
}

std::vector<std::string> ParseTexts(const std::string& option,
                                    const std::vector<std::string>& texts) {
  std::vector<std::string> values;
  for (const std::string& text : texts) {
    if (text.empty()) Refuse(option, "values with commas between them", text);
    AddOnce(values, text);
  }
  return values;
}

}  // namespace ronda
