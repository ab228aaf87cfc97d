// The other process of the tests of common/run: run_test_helper MODE [ARGUMENT]…
//   hold FD              writes a byte to FD and waits to be killed
//   parent FD LOG        starts `hold FD` as its child and waits to be killed
//   stop FD STATUS       under RunProcess: writes a byte to FD, waits for a stop, returns STATUS
//   stop-twice           under RunProcess: SIGTERM and then SIGINT to itself, returns 0
//   throw KIND           under RunProcess: throws error, standard or number
//   lock FOLDER          under RunProcess: takes the run folder
//   orphan PID           EndWithParent(PID), then exits with 5
//   domain NUMBER        under RunProcess: takes exactly that DDS domain
#include <unistd.h>

#include <condition_variable>
#include <csignal>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/run/child_process.h"
#include "common/run/paths.h"
#include "common/run/process.h"
#include "common/run/run_domain.h"
#include "common/run/run_folder.h"

namespace ronda {
namespace {

void SayReady(const std::string& descriptor) {
  if (::write(std::stoi(descriptor), "r", 1) != 1) ::_exit(99);
}

[[noreturn]] void WaitToBeKilled() {
  ::alarm(60);  // where the test fails, nothing is left behind
  while (true) ::pause();
}

void WaitForStop(std::stop_token stop) {
  std::mutex mutex;
  std::condition_variable_any changed;
  std::unique_lock lock(mutex);
  changed.wait(lock, stop, [] { return false; });
}

int StopTwice(std::stop_token stop) {
  ::kill(::getpid(), SIGTERM);
  WaitForStop(stop);
  ::kill(::getpid(), SIGINT);
  sigset_t pending;
  do {
    std::this_thread::yield();
    ::sigpending(&pending);
  } while (sigismember(&pending, SIGINT) == 1);
  return 0;
}

int Throw(const std::string& kind) {
  if (kind == "error") throw DivergenceError("loss of update 12: must be finite, got nan");
  if (kind == "standard") throw std::runtime_error("something else");
  throw 7;
}

int RunMode(const std::vector<std::string>& words, std::stop_token stop) {
  const std::string& mode = words.at(0);
  if (mode == "stop") {
    SayReady(words.at(1));
    WaitForStop(stop);
    return std::stoi(words.at(2));
  }
  if (mode == "stop-twice") return StopTwice(stop);
  if (mode == "throw") return Throw(words.at(1));
  if (mode == "lock") {
    const RunFolder folder(words.at(1));
    return 0;
  }
  if (mode == "domain") {
    const int number = std::stoi(words.at(1));
    const RunDomain domain(0, {number, number});
    return 0;
  }
  return 98;
}

int Main(const std::vector<std::string>& words) {
  const std::string& mode = words.at(0);
  if (mode == "hold") {
    SayReady(words.at(1));
    WaitToBeKilled();
  }
  if (mode == "parent") {
    const ChildProcess child(ProgramFolder() / "run_test_helper", {"hold", words.at(1)},
                             words.at(2));
    WaitToBeKilled();
  }
  if (mode == "orphan") {
    EndWithParent(std::stoi(words.at(1)));
    return 5;
  }
  return RunProcess("helper", [&](std::stop_token stop) { return RunMode(words, stop); });
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  return ronda::Main(std::vector<std::string>(argv + 1, argv + argc));
}
