#pragma once
// `ronda`, or any program, run to its end by a test, with how it ended and what it printed.
#include <sys/wait.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

namespace ronda::testing {

struct CommandResult {
  int status;
  std::string output;  // stdout and stderr
};

inline CommandResult Shell(const std::string& command) {
  FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  CommandResult result{};
  std::array<char, 4096> buffer{};
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    result.output.append(buffer.data(), n);
  }
  result.status = WEXITSTATUS(::pclose(pipe));
  return result;
}

/// `environment`: assignments as a shell writes them.
inline CommandResult Ronda(const std::string& arguments, const std::string& environment = "") {
  return Shell(environment + " " RONDA_BIN_DIR "/ronda " + arguments);
}

}  // namespace ronda::testing
