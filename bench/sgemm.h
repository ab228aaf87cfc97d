#pragma once
// OpenBLAS's product of two 1024 × 1024 float matrices on one thread: what this machine can do.
//
// A reference only; nothing else of Ronda uses it. Without OpenBLAS at build time there is none.
#include <functional>
#include <string>

namespace ronda::bench {

constexpr double kSgemmFlop = 2.0 * 1024 * 1024 * 1024;  // of one call

struct Sgemm {
  std::string name;            // version and kernel
  std::function<void()> call;  // empty where OpenBLAS is missing
};

Sgemm MakeSgemm();

}  // namespace ronda::bench
