// A replay that a test kills: dds_test_replay_program DOMAIN RUN INCARNATION
// SOCKET_BUFFER_BYTES FILE.
//
// Appends the reward of each transition that it stores to FILE, as a float, and does so before its
// status says that it is stored. Ends at SIGTERM.
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "common/base/error.h"
#include "common/run/process.h"
#include "tests/dds/small_replay.h"

namespace ronda {
namespace {

int Body(int argc, char** argv, std::stop_token stop) {
  if (argc != 6) throw UsageError("give domain, run, incarnation, socket buffer bytes and file");
  EndWithParent();
  std::FILE* file = std::fopen(argv[5], "ab");
  if (file == nullptr) throw InputError(fmt::format("{}: cannot be opened", argv[5]));
  std::setvbuf(file, nullptr, _IONBF, 0);
  dds::Participant participant({.domain = std::stoi(argv[1]),
                                .run_id = argv[2],
                                .name = "replay",
                                .socket_buffer_bytes = std::stoi(argv[4])});
  SmallReplay replay(participant, UnlimitedReplay(), std::stoull(argv[3]),
                     [&](float reward) { std::fwrite(&reward, sizeof reward, 1, file); });
  while (!stop.stop_requested()) replay.Step();
  std::fclose(file);
  return 0;
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  return ronda::RunProcess("dds_test_replay_program", [&](std::stop_token stop) {
    return ronda::Body(argc, argv, std::move(stop));
  });
}
