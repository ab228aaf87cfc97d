#pragma once
// A child process whose output goes to a log file, and that ends when its parent does.
//
// Started by fork and exec, in a process group of its own (Ctrl-C reaches the parent only), with
// SIGTERM as parent-death signal. That signal follows the *thread* that forked: start children from
// a thread that lives as long as the parent. A program that cannot be executed is an Error with the
// reason. The destructor kills a child that still runs. Thread-compatible. Linux only.
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ronda {

/// How a process ended: by exit(status), or by a signal.
struct ExitStatus {
  int code = 0;                     // where signal = 0
  int signal = 0;                   // 0: none
  std::string Description() const;  // "exit status 3", "signal 9 (Killed)"
};

class ChildProcess {
 public:
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log_file);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  pid_t pid() const { return pid_; }
  /// How it ended; nullopt while it runs. Never blocks.
  std::optional<ExitStatus> Poll();
  std::optional<ExitStatus> WaitFor(std::chrono::milliseconds at_most);
  void Signal(int signal);  // nothing if it has ended

 private:
  pid_t pid_ = -1;
  std::optional<ExitStatus> exit_status_;
};

/// The last `count` lines of a text file; empty where it cannot be read.
std::vector<std::string> LastLines(const std::filesystem::path& file, std::size_t count);

}  // namespace ronda
