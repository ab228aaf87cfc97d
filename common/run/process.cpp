#include "common/run/process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <thread>

#include "common/base/error.h"
#include "common/base/file_descriptor.h"

namespace ronda {
namespace {

constexpr int kOtherException = 1;

/// Blocks SIGINT and SIGTERM, and requests a stop when the first one comes.
class SignalWatch {
 public:
  SignalWatch() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    signals_ = FileDescriptor(::signalfd(-1, &signals, SFD_CLOEXEC));
    end_ = FileDescriptor(::eventfd(0, EFD_CLOEXEC));
    if (!signals_.is_open() || !end_.is_open()) {
      throw Error(ExitCode::kTransport, fmt::format("signals: {}", std::strerror(errno)));
    }
    thread_ = std::thread([this] { Watch(); });
  }

  ~SignalWatch() {
    ::eventfd_write(end_.number(), 1);
    thread_.join();
  }

  std::stop_token stop_token() const { return stop_.get_token(); }
  int first_signal() const { return first_signal_; }  // 0: none

 private:
  void Watch() {
    pthread_setname_np(pthread_self(), "signals");
    pollfd watched[2] = {{signals_.number(), POLLIN, 0}, {end_.number(), POLLIN, 0}};
    while (true) {
      if (::poll(watched, 2, -1) < 0) continue;  // EINTR
      signalfd_siginfo info;
      if (watched[0].revents != 0 && ::read(signals_.number(), &info, sizeof info) == sizeof info &&
          first_signal_ == 0) {
        first_signal_ = static_cast<int>(info.ssi_signo);
        stop_.request_stop();
      }
      if (watched[1].revents != 0) return;
    }
  }

  FileDescriptor signals_;
  FileDescriptor end_;
  std::stop_source stop_;
  std::atomic<int> first_signal_{0};
  std::thread thread_;
};

int PrintFailure(const std::string& name, const char* message, int exit_status) {
  std::fprintf(stderr, "%s: %s\n", name.c_str(), message);
  return exit_status;
}

}  // namespace

int RunProcess(const std::string& name, const std::function<int(std::stop_token stop)>& body) {
  std::signal(SIGCHLD, SIG_DFL);  // where it came ignored, no child's end could be read
  std::signal(SIGPIPE, SIG_IGN);  // a pipe that nobody reads is a failed write
  try {
    SignalWatch watch;
    const int status = body(watch.stop_token());
    return status == 0 && watch.first_signal() != 0 ? 128 + watch.first_signal() : status;
  } catch (const Error& error) {
    return PrintFailure(name, error.what(), static_cast<int>(error.exit_code()));
  } catch (const std::exception& error) {
    return PrintFailure(name, error.what(), kOtherException);
  } catch (...) {
    return PrintFailure(name, "an exception that is no std::exception", kOtherException);
  }
}

void EndWithParent(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::raise(SIGTERM);
}

}  // namespace ronda
