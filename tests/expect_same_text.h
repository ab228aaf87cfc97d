#pragma once
// Compares a text with the one that is kept, line by line; the first line that differs is what the
// failing test shows, with the command that writes the file anew after a deliberate change.
#include <catch2/catch.hpp>
#include <sstream>
#include <string>

namespace ronda::testing {

/// Where two texts first differ: line number, both lines; empty where they are equal.
inline std::string FirstDifference(const std::string& actual, const std::string& kept) {
  if (actual == kept) return "";
  std::istringstream actual_lines(actual);
  std::istringstream kept_lines(kept);
  for (int number = 1;; ++number) {
    std::string now = "(the text ends)";
    std::string before = now;
    const bool more_now = static_cast<bool>(std::getline(actual_lines, now));
    const bool more_before = static_cast<bool>(std::getline(kept_lines, before));
    if (!more_now && !more_before) return "the last line's end differs";
    if (!more_now) now = "(the text ends)";
    if (!more_before) before = "(the text ends)";
    if (now != before || more_now != more_before) {
      return "line " + std::to_string(number) + "\n  kept: " + before + "\n  now:  " + now;
    }
  }
}

inline void ExpectSameText(const std::string& actual, const std::string& kept,
                           const std::string& regenerate) {
  INFO("If the change is meant: " << regenerate);
  CHECK(FirstDifference(actual, kept) == "");
}

}  // namespace ronda::testing
