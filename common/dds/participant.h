#pragma once
// A process's membership in a DDS domain: one UDPv4 transport on the loopback interface, discovery
// by unicast, one partition for each run.
//
// One a process is enough; it must outlive every endpoint that is built on it. Discovery needs no
// multicast: each participant announces itself to the ports of the first `kMaxParticipants`
// participant ids of its domain on 127.0.0.1, so at most that many processes share a domain.
// Throws TransportError when the domain cannot be joined. Thread-safe. What is built on it is not
// visible here: no header of this folder shows Fast DDS. See docs/protocol.md.
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ronda::dds {

inline constexpr int kMaxDomain = 232;  // the last one whose ports fit in 16 bits
inline constexpr int kMaxParticipants = 100;

struct ParticipantOptions {
  int domain = 0;                     // 0 … kMaxDomain
  std::string run_id;                 // the partition: only equal ones meet
  std::string name;                   // of this process, for tools
  int socket_buffer_bytes = 4 << 20;  // asked for; what the kernel gives is enough
  // A silent peer is dropped after it. Long, since no write waits for it, and since this version
  // does not always match again after one side alone has dropped the other.
  std::chrono::milliseconds participant_lease{30'000};
};

/// What a process has written to a topic.
struct Traffic {
  std::string topic;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;  // serialised, without the headers of RTPS and UDP
};

class Participant {
 public:
  explicit Participant(const ParticipantOptions& options);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// One sentence for the log: the socket buffers asked for and what the kernel grants.
  const std::string& socket_buffer_report() const;

  /// One entry for each topic that this participant has a writer of, by name.
  std::vector<Traffic> Written() const;

  struct Impl;  // for this folder only
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
