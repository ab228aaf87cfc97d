#pragma once
// A child process whose output is appended to a log file, and that ends when its parent does.
//
// fork and exec; a process group of its own, so that Ctrl-C reaches the parent only; stdin is
// /dev/null; no signal is blocked; SIGTERM comes when the parent ends. That last one follows the
// *thread* that forked, so start children from the main thread (or one that lives as long). Errors:
// InputError where the log cannot be opened, Error(kChildGaveUp) where the program cannot be
// executed or the system gives no process, each with the reason. The destructor kills (SIGKILL) and
// reaps a child that still runs. Thread-compatible. Linux only.
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ronda {

/// How a process ended: by exit(code), or by a signal.
struct ExitStatus {
  int code = 0;    // where signal = 0
  int signal = 0;  // 0: none
  /// "exit status 3", "signal 9 (Killed)".
  std::string Description() const;
};

class ChildProcess {
 public:
  /// `program` is a path, not searched in PATH; `arguments` without the program's name.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log_file);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  pid_t pid() const { return pid_; }
  /// How it ended; nullopt while it runs. Never blocks.
  std::optional<ExitStatus> Poll();
  /// As Poll, but waits up to `at_most` for the end.
  std::optional<ExitStatus> WaitFor(std::chrono::milliseconds at_most);
  /// Nothing where it has ended.
  void Signal(int signal);
  std::vector<std::string> LastLogLines(std::size_t count) const;

 private:
  pid_t pid_ = -1;  // −1: moved from
  std::filesystem::path log_file_;
  std::optional<ExitStatus> exit_status_;
};

}  // namespace ronda
