#pragma once
// A DDS domain (1 … 100) that this run has to itself on this machine.
//
// Held by binding a loopback TCP port that the domain gives (a lock file would not be seen from a
// container that shares the network). Ends with the process. TransportError where all are taken.
#include <cstdint>

namespace ronda {

class RunDomain {
 public:
  /// Tries all domains, beginning at one that `hint` gives.
  explicit RunDomain(std::uint64_t hint);
  ~RunDomain();
  RunDomain(const RunDomain&) = delete;
  RunDomain& operator=(const RunDomain&) = delete;

  int domain() const { return domain_; }

 private:
  int domain_ = 0;
  int socket_ = -1;
};

}  // namespace ronda
