#include "common/run/run_domain.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "common/base/error.h"

namespace ronda {
namespace {

constexpr int kDomains = 100;
constexpr int kFirstPort = 7300;  // below the ports of domain 0 (7400 …)

}  // namespace

RunDomain::RunDomain(std::uint64_t hint) {
  for (int attempt = 0; attempt < kDomains; ++attempt) {
    const int domain = 1 + static_cast<int>((hint + attempt) % kDomains);
    const int candidate = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (candidate < 0) break;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(kFirstPort + domain - 1));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (bind(candidate, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
        listen(candidate, 1) == 0) {
      domain_ = domain;
      socket_ = candidate;
      return;
    }
    close(candidate);
  }
  throw TransportError(
      "no DDS domain from 1 to 100 is free on this machine (each run holds loopback port 7299 + "
      "its domain)");
}

RunDomain::~RunDomain() { close(socket_); }

}  // namespace ronda
