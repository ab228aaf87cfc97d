#include "common/run/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <thread>
#include <utility>

#include "common/base/error.h"

namespace ronda {
namespace {

/// In the child, between fork and exec: only async-signal-safe calls. Never returns.
[[noreturn]] void BecomeProgram(const char* program, char* const* arguments, int log, int failure,
                                pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(128 + SIGTERM);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (null >= 0) dup2(null, STDIN_FILENO);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  execv(program, arguments);
  const int reason = errno;
  (void)!write(failure, &reason, sizeof reason);
  _exit(127);
}

}  // namespace

std::string ExitStatus::Description() const {
  if (signal == 0) return fmt::format("exit status {}", code);
  return fmt::format("signal {} ({})", signal, strsignal(signal));
}

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments,
                           const std::filesystem::path& log_file) {
  const int log = open(log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0) {
    throw InputError(
        fmt::format("{}: cannot be opened for writing: {}", log_file.string(), strerror(errno)));
  }
  int failure[2];
  if (pipe2(failure, O_CLOEXEC) != 0) {
    close(log);
    throw Error(ExitCode::kChildGaveUp, fmt::format("no pipe: {}", strerror(errno)));
  }
  const std::string path = program.string();
  std::vector<char*> argv{const_cast<char*>(path.c_str())};
  for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) BecomeProgram(path.c_str(), argv.data(), log, failure[1], parent);
  const int fork_error = errno;
  close(log);
  close(failure[1]);
  int reason = 0;
  const bool failed = pid_ > 0 && read(failure[0], &reason, sizeof reason) == sizeof reason;
  close(failure[0]);
  if (pid_ < 0 || failed) {
    if (failed) waitpid(pid_, nullptr, 0);
    throw Error(ExitCode::kChildGaveUp, fmt::format("{}: cannot be started: {}", path,
                                                    strerror(failed ? reason : fork_error)));
  }
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), exit_status_(other.exit_status_) {}

ChildProcess::~ChildProcess() {
  if (pid_ < 0 || Poll()) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

std::optional<ExitStatus> ChildProcess::Poll() {
  if (exit_status_) return exit_status_;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) == pid_) {
    exit_status_ = WIFSIGNALED(status) ? ExitStatus{.code = 0, .signal = WTERMSIG(status)}
                                       : ExitStatus{.code = WEXITSTATUS(status), .signal = 0};
  }
  return exit_status_;
}

std::optional<ExitStatus> ChildProcess::WaitFor(std::chrono::milliseconds at_most) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (!Poll() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return exit_status_;
}

void ChildProcess::Signal(int signal) {
  if (!Poll()) kill(pid_, signal);
}

std::vector<std::string> LastLines(const std::filesystem::path& file, std::size_t count) {
  constexpr std::streamoff kTail = 16'384;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  stream.seekg(size > kTail ? size - kTail : 0);
  std::deque<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  return {lines.begin(), lines.end()};
}

}  // namespace ronda
