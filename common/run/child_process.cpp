#include "common/run/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/base/file_descriptor.h"
#include "common/base/whole_file.h"
#include "common/run/process.h"

namespace ronda {
namespace {

struct ChildSetup {
  const char* program;
  char** arguments;
  int null_input;
  int log;
  int failure;  // takes errno where exec fails; closes by itself where it succeeds
  pid_t parent;
};

/// What the child does between fork and exec: async-signal-safe calls only.
[[noreturn]] void BecomeProgram(const ChildSetup& setup) {
  ::setpgid(0, 0);
  EndWithParent(setup.parent);  // a SIGTERM that it raises is still blocked, or ends us here
  const bool wired = ::dup2(setup.null_input, STDIN_FILENO) >= 0 &&
                     ::dup2(setup.log, STDOUT_FILENO) >= 0 && ::dup2(setup.log, STDERR_FILENO) >= 0;
  std::signal(SIGPIPE, SIG_DFL);  // RunProcess ignores it
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (wired) ::execv(setup.program, setup.arguments);
  const int reason = errno;
  [[maybe_unused]] const ssize_t written = ::write(setup.failure, &reason, sizeof reason);
  ::_exit(127);
}

/// 0 once the child has become its program, else the errno that stopped it.
int ReadFailure(const FileDescriptor& pipe) {
  int reason = 0;
  ssize_t count = 0;
  do {
    count = ::read(pipe.number(), &reason, sizeof reason);
  } while (count < 0 && errno == EINTR);
  return count == sizeof reason ? reason : 0;
}

pid_t WaitForPid(pid_t pid, int* status, int options) {
  pid_t waited = 0;
  do {
    waited = ::waitpid(pid, status, options);
  } while (waited < 0 && errno == EINTR);
  return waited;
}

}  // namespace

std::string ExitStatus::Description() const {
  if (signal == 0) return fmt::format("exit status {}", code);
  return fmt::format("signal {} ({})", signal, ::strsignal(signal));
}

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments,
                           const std::filesystem::path& log_file)
    : log_file_(log_file) {
  const FileDescriptor log(
      ::open(log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!log.is_open()) {
    throw InputError(
        fmt::format("{}: the log cannot be opened: {}", log_file.string(), std::strerror(errno)));
  }
  const FileDescriptor null_input(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  int ends[2] = {-1, -1};
  const bool has_pipe = ::pipe2(ends, O_CLOEXEC) == 0;
  const FileDescriptor failure_out(ends[0]);
  FileDescriptor failure_in(ends[1]);
  const ChildSetup setup{words[0].c_str(), pointers.data(),     null_input.number(),
                         log.number(),     failure_in.number(), ::getpid()};
  pid_ = has_pipe ? ::fork() : -1;
  if (pid_ < 0) {
    throw Error(ExitCode::kChildGaveUp,
                fmt::format("{}: cannot be started: {}", program.string(), std::strerror(errno)));
  }
  if (pid_ == 0) BecomeProgram(setup);
  failure_in.Close();
  if (const int reason = ReadFailure(failure_out); reason != 0) {
    WaitForPid(pid_, nullptr, 0);
    throw Error(ExitCode::kChildGaveUp,
                fmt::format("{}: cannot be executed: {}", program.string(), std::strerror(reason)));
  }
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      log_file_(std::move(other.log_file_)),
      exit_status_(other.exit_status_) {}

ChildProcess::~ChildProcess() {
  if (pid_ < 0 || exit_status_) return;
  ::kill(pid_, SIGKILL);
  WaitForPid(pid_, nullptr, 0);
}

std::optional<ExitStatus> ChildProcess::Poll() {
  if (exit_status_) return exit_status_;
  int status = 0;
  const pid_t waited = WaitForPid(pid_, &status, WNOHANG);
  RONDA_CHECK(waited >= 0, "waitpid({}): {}", pid_, std::strerror(errno));
  if (waited == 0) return std::nullopt;
  exit_status_ = WIFSIGNALED(status) ? ExitStatus{.code = 0, .signal = WTERMSIG(status)}
                                     : ExitStatus{.code = WEXITSTATUS(status), .signal = 0};
  return exit_status_;
}

std::optional<ExitStatus> ChildProcess::WaitFor(std::chrono::milliseconds at_most) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (true) {
    if (const auto status = Poll()) return status;
    const auto left = deadline - std::chrono::steady_clock::now();
    if (left <= left.zero()) return std::nullopt;
    std::this_thread::sleep_for(
        std::min<std::chrono::steady_clock::duration>(left, std::chrono::milliseconds(5)));
  }
}

void ChildProcess::Signal(int signal) {
  if (!Poll()) ::kill(pid_, signal);  // not reaped yet, so the number is still this child's
}

std::vector<std::string> ChildProcess::LastLogLines(std::size_t count) const {
  return LastLines(log_file_, count);
}

}  // namespace ronda
