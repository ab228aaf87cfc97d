#pragma once
// A DDS domain that this run has to itself on this machine.
//
// Held by binding the loopback TCP port 7400 + 250 · domain + 249: it lies among the domain's own
// ports (RTPS 2.3 §9.6.1.1), which DDS uses for UDP only, and below the ephemeral range of Linux; a
// container that shares the network sees it too. Ends with the object or the process; not inherited
// by children. TransportError where every domain of the range is taken. Thread-compatible.
#include <cstdint>

#include "common/base/file_descriptor.h"

namespace ronda {

struct DomainRange {
  int first = 1;
  int last = 100;
};

class RunDomain {
 public:
  /// Tries all domains of the range once, beginning at one that follows from `hint` (say, a hash of
  /// the run folder's path).
  explicit RunDomain(std::uint64_t hint, DomainRange range = {});

  int domain() const { return domain_; }

 private:
  int domain_ = 0;
  FileDescriptor socket_;
};

}  // namespace ronda
