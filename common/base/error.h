#pragma once
// The exceptions that end a process, and the exit status that each maps to.
//
// Thrown where a process cannot start or go on; caught once, in run/RunProcess (and in the front
// command), which prints `what()` as one line and exits with `exit_code()`. What is expected at run
// time (a time-out, a throttled push, a malformed message) is an enum or an optional instead, and a
// bug is a RONDA_CHECK.
#include <stdexcept>
#include <string>

namespace ronda {

enum class ExitCode : int {
  kOk = 0,
  kUsage = 2,           // the command line
  kInput = 3,           // a configuration or input file
  kTransport = 4,       // DDS could not be set up, or a peer that is needed stayed away
  kCheckpoint = 5,      // a checkpoint or policy file that cannot be read or written
  kDivergence = 6,      // a loss that is not finite
  kChildGaveUp = 7,     // a child process died too often
  kRunFolderInUse = 8,  // another launcher holds the run folder
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode exit_code, const std::string& message)
      : std::runtime_error(message), exit_code_(exit_code) {}
  ExitCode exit_code() const { return exit_code_; }

 private:
  ExitCode exit_code_;
};

class UsageError : public Error {
 public:
  explicit UsageError(const std::string& message) : Error(ExitCode::kUsage, message) {}
};

/// A configuration, map or other input that breaks a rule; the message names file, line or element,
/// rule and value.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::kInput, message) {}
};

class TransportError : public Error {
 public:
  explicit TransportError(const std::string& message) : Error(ExitCode::kTransport, message) {}
};

class CheckpointError : public Error {
 public:
  explicit CheckpointError(const std::string& message) : Error(ExitCode::kCheckpoint, message) {}
};

class DivergenceError : public Error {
 public:
  explicit DivergenceError(const std::string& message) : Error(ExitCode::kDivergence, message) {}
};

}  // namespace ronda
