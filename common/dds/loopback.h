#pragma once
// What the kernel has for us: the loopback interface, and what it grants a UDP socket that asks for
// large buffers (Linux caps it silently at net.core.rmem_max and net.core.wmem_max). No errors: a
// socket that cannot be opened grants 0.
#include <string>

namespace ronda::dds {

struct SocketBuffers {
  int receive_bytes = 0;
  int send_bytes = 0;
};

SocketBuffers ProbeSocketBuffers(int asked_bytes);

/// Whether there is a way to 127.0.0.1; Fast DDS says nothing where there is none.
bool LoopbackIsUp();

/// One sentence that names both and, where less was granted, the sysctl that gives more.
std::string DescribeSocketBuffers(int asked_bytes, const SocketBuffers& granted);

}  // namespace ronda::dds
