#pragma once
// Which instruction set the float loops of this process run on.
//
// One binary holds them compiled for each (loops.h). The first call takes the best that the CPU
// has, or the one that the environment variable RONDA_KERNEL names (baseline, avx2, avx512).
// Results are the same bits each time on one kernel, and differ by rounding between kernels.
// UsageError for a name that is unknown or that this CPU lacks. Thread-safe but for UseKernel.
#include <string_view>
#include <vector>

namespace ronda {

enum class Kernel {
  kBaseline,  // what every CPU of the architecture has: SSE2 on x86-64
  kAvx2,      // with FMA
  kAvx512,    // F and VL, with FMA
};

std::string_view NameOf(Kernel kernel);

/// Of this CPU, slowest first; never empty.
std::vector<Kernel> AvailableKernels();

Kernel KernelInUse();

/// From now on this process uses `kernel`, which is available (else a bug). For tests and
/// benchmarks, while no other thread computes.
void UseKernel(Kernel kernel);

}  // namespace ronda
