#pragma once
// What a seed on the command line must be. CLI11 itself takes -1 and numbers of any size for an
// unsigned integer and turns them into another one.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string>

namespace ronda {

/// For CLI::Option::check: a whole number in 0 … 2^64 - 1.
inline CLI::Validator SeedRule() {
  const auto check = [](const std::string& text) -> std::string {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed);
    if (error == std::errc() && stop == end) return {};
    return "must be a whole number in 0 … 18446744073709551615, got " + text;
  };
  return {check, ""};
}

}  // namespace ronda
