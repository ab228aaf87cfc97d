#include "common/run/run_domain.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/base/rng.h"

namespace ronda {
namespace {

/// Open where the port was free.
FileDescriptor BindDomain(int domain) {
  FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!socket.is_open()) throw TransportError(fmt::format("socket: {}", std::strerror(errno)));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain + 249));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (errno == EADDRINUSE) return FileDescriptor();
    throw TransportError(fmt::format("DDS domain {}: its loopback port cannot be bound: {}", domain,
                                     std::strerror(errno)));
  }
  return socket;
}

}  // namespace

RunDomain::RunDomain(std::uint64_t hint, DomainRange range) {
  RONDA_CHECK(0 <= range.first && range.first <= range.last && range.last <= 100,
              "domains {} to {}", range.first, range.last);
  const int count = range.last - range.first + 1;
  const int start = static_cast<int>(Rng::NextSplitMix(hint) % static_cast<std::uint64_t>(count));
  for (int i = 0; i < count && !socket_.is_open(); ++i) {
    domain_ = range.first + (start + i) % count;
    socket_ = BindDomain(domain_);
  }
  if (!socket_.is_open()) {
    throw TransportError(
        fmt::format("DDS domains {} to {} are all taken by other runs", range.first, range.last));
  }
}

}  // namespace ronda
