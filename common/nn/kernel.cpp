#include "common/nn/kernel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

#include "common/base/check.h"
#include "common/base/error.h"
#include "common/nn/loops.h"

namespace ronda {
namespace {

constexpr const char* kVariable = "RONDA_KERNEL";
constexpr std::array kAllKernels = {Kernel::kBaseline, Kernel::kAvx2, Kernel::kAvx512};

bool CpuHas(Kernel kernel) {
#if defined(__x86_64__)
  if (kernel == Kernel::kAvx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (kernel == Kernel::kAvx512)
    return CpuHas(Kernel::kAvx2) && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512vl");
#endif
  return kernel == Kernel::kBaseline;
}

Kernel ChooseKernel() {
  const std::vector<Kernel> available = AvailableKernels();
  const char* const wanted = std::getenv(kVariable);
  if (wanted == nullptr || *wanted == '\0') return available.back();
  std::vector<std::string_view> names;
  for (const Kernel kernel : available) {
    names.push_back(NameOf(kernel));
    if (names.back() == wanted) return kernel;
  }
  const bool known = std::any_of(kAllKernels.begin(), kAllKernels.end(),
                                 [&](Kernel kernel) { return NameOf(kernel) == wanted; });
  throw UsageError(fmt::format("{} is \"{}\", {}; this CPU has: {}", kVariable, wanted,
                               known ? "which this CPU lacks" : "which is no kernel",
                               fmt::join(names, ", ")));
}

/// The one choice of the process.
std::atomic<Kernel>& Choice() {
  static std::atomic<Kernel> choice(ChooseKernel());
  return choice;
}

}  // namespace

std::string_view NameOf(Kernel kernel) {
  switch (kernel) {
    case Kernel::kAvx2:
      return "avx2";
    case Kernel::kAvx512:
      return "avx512";
    default:
      return "baseline";
  }
}

std::vector<Kernel> AvailableKernels() {
  std::vector<Kernel> available;
  std::copy_if(kAllKernels.begin(), kAllKernels.end(), std::back_inserter(available), CpuHas);
  return available;
}

Kernel KernelInUse() { return Choice().load(std::memory_order_relaxed); }

void UseKernel(Kernel kernel) {
  RONDA_CHECK(CpuHas(kernel), "this CPU lacks {}", NameOf(kernel));
  Choice().store(kernel, std::memory_order_relaxed);
}

const Loops& LoopsInUse() {
  switch (KernelInUse()) {
#if defined(__x86_64__)
    case Kernel::kAvx2:
      return kLoopsAvx2;
    case Kernel::kAvx512:
      return kLoopsAvx512;
#endif
    default:
      return kLoopsBaseline;
  }
}

}  // namespace ronda
