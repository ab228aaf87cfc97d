#include "common/dds/loopback.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

namespace ronda::dds {
namespace {

int Granted(int socket_fd, int option, int asked_bytes) {
  (void)setsockopt(socket_fd, SOL_SOCKET, option, &asked_bytes, sizeof(asked_bytes));
  int doubled_bytes = 0;  // the kernel counts its own overhead as as much again
  socklen_t size = sizeof(doubled_bytes);
  if (getsockopt(socket_fd, SOL_SOCKET, option, &doubled_bytes, &size) != 0) return 0;
  return doubled_bytes / 2;
}

}  // namespace

SocketBuffers ProbeSocketBuffers(int asked_bytes) {
  const int socket_fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket_fd < 0) return {};
  const SocketBuffers granted{.receive_bytes = Granted(socket_fd, SO_RCVBUF, asked_bytes),
                              .send_bytes = Granted(socket_fd, SO_SNDBUF, asked_bytes)};
  close(socket_fd);
  return granted;
}

bool LoopbackIsUp() {
  const int socket_fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket_fd < 0) return false;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(9);  // any; connecting sends nothing, but needs a route
  const bool reachable =
      connect(socket_fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  close(socket_fd);
  return reachable;
}

std::string DescribeSocketBuffers(int asked_bytes, const SocketBuffers& granted) {
  std::string sentence =
      fmt::format("UDP buffers: asked for {} bytes, granted {} to receive and {} to send",
                  asked_bytes, granted.receive_bytes, granted.send_bytes);
  if (std::min(granted.receive_bytes, granted.send_bytes) < asked_bytes) {
    sentence += fmt::format(
        "; it works, and `sysctl -w net.core.rmem_max={0} net.core.wmem_max={0}` makes it faster",
        asked_bytes);
  }
  return sentence;
}

}  // namespace ronda::dds
