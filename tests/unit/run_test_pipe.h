#pragma once
// A pipe whose write end the programs that a test starts inherit: they say that they are ready, and
// the end of the last of them is the end of the file. Waits at most 20 s. Thread-compatible.
#include <poll.h>
#include <unistd.h>

#include <string>

#include "common/base/check.h"
#include "common/base/file_descriptor.h"

namespace ronda {

class TestPipe {
 public:
  enum class Event { kReady, kAllEnded, kNothing };

  TestPipe() {
    int ends[2];
    RONDA_CHECK(::pipe(ends) == 0, "pipe");
    out_ = FileDescriptor(ends[0]);
    in_ = FileDescriptor(ends[1]);
  }

  std::string number() const { return std::to_string(in_.number()); }
  /// After the programs have started: only they hold the write end then.
  void CloseOwnEnd() { in_.Close(); }

  Event Next() {
    pollfd watched{out_.number(), POLLIN, 0};
    if (::poll(&watched, 1, 20'000) != 1) return Event::kNothing;
    char byte = 0;
    return ::read(out_.number(), &byte, 1) == 1 ? Event::kReady : Event::kAllEnded;
  }

 private:
  FileDescriptor out_;
  FileDescriptor in_;
};

}  // namespace ronda
