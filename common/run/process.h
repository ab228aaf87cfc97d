#pragma once
// What every main does: signals become a stop_token, exceptions become one line and an exit status.
//
// Linux only. Not thread-safe: called from main, before any other thread starts.
#include <sys/types.h>
#include <unistd.h>

#include <functional>
#include <stop_token>
#include <string>

namespace ronda {

/// Runs `body` and returns the exit status of the process.
///
/// SIGINT and SIGTERM are blocked from here on, in all threads that start later too; one thread
/// waits for them. The first requests `stop`; later ones change nothing, so that a checkpoint is
/// never cut short (SIGKILL still ends the process). A body that returns 0 after that gives
/// 128 + signal (130 or 143), any other return stands. An Error is printed to stderr as
/// `name: message` and gives its exit code, any other exception gives 1.
/// SIGPIPE is ignored.
int RunProcess(const std::string& name, const std::function<int(std::stop_token stop)>& body);

/// From now on this process gets SIGTERM when its parent ends, and at once where `parent` is not
/// its parent any more (taken before the fork, it closes the race). The signal follows the parent's
/// *thread* that forked. Async-signal-safe.
void EndWithParent(pid_t parent = ::getppid());

}  // namespace ronda
