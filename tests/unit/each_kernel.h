#pragma once
// Runs a test's claim once on each kernel that this CPU has, and then puts the first choice back.
#include <catch2/catch.hpp>
#include <string>

#include "common/nn/kernel.h"

namespace ronda::testing {

template <typename Claim>
void OnEachKernel(Claim claim) {
  const Kernel before = KernelInUse();
  for (const Kernel kernel : AvailableKernels()) {
    INFO("kernel " << std::string(NameOf(kernel)));
    UseKernel(kernel);
    claim();
  }
  UseKernel(before);
}

}  // namespace ronda::testing
