#pragma once
// RONDA_CHECK(condition, format, values…): an always-on check of what only a bug can break.
// Prints file, line, condition and the formatted values to stderr, then aborts (exit status 134).
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace ronda::internal {

[[noreturn]] inline void CheckFailed(const char* file, int line, const char* condition,
                                     const std::string& values) {
  std::fprintf(stderr, "%s:%d: check failed: %s: %s\n", file, line, condition, values.c_str());
  std::fflush(stderr);
  std::abort();
}

}  // namespace ronda::internal

#define RONDA_CHECK(condition, ...)                                                               \
  do {                                                                                            \
    if (!(condition)) [[unlikely]]                                                                \
      ::ronda::internal::CheckFailed(__FILE__, __LINE__, #condition, ::fmt::format(__VA_ARGS__)); \
  } while (false)
