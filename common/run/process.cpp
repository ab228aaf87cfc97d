#include "common/run/process.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <thread>

#include "common/base/error.h"

namespace ronda {
namespace {

sigset_t StopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Waits for signals on a thread of its own until told to stop.
class SignalWatch {
 public:
  explicit SignalWatch(std::stop_source& stop)
      : thread_([this, &stop](std::stop_token done) {
          const sigset_t signals = StopSignals();
          const timespec slice{.tv_sec = 0, .tv_nsec = 50'000'000};
          while (!done.stop_requested()) {
            const int signal = sigtimedwait(&signals, nullptr, &slice);
            if (signal <= 0) continue;
            int none = 0;
            first_.compare_exchange_strong(none, signal);
            stop.request_stop();
          }
        }) {}

  int first() const { return first_; }

 private:
  std::atomic<int> first_ = 0;
  std::jthread thread_;
};

int RunBody(const std::string& name, const std::function<int(std::stop_token)>& body,
            std::stop_token stop) {
  try {
    return body(std::move(stop));
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return static_cast<int>(error.exit_code());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 1;
  }
}

}  // namespace

int RunProcess(const std::string& name, const std::function<int(std::stop_token)>& body) {
  const sigset_t signals = StopSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::stop_source stop;
  SignalWatch watch(stop);
  const int status = RunBody(name, body, stop.get_token());
  return status == 0 && watch.first() != 0 ? 128 + watch.first() : status;
}

void EndWithParent() {
  const pid_t parent = getppid();
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent || parent == 1) std::raise(SIGTERM);
}

}  // namespace ronda
