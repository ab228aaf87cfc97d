// One whole update through each kernel, and how a process is told which to use.
#include "common/nn/kernel.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/random_batch.h"
#include "learner/dqn.h"
#include "tests/unit/each_kernel.h"

namespace ronda {
namespace {

using testing::OnEachKernel;

/// Widths that leave columns and rows over on every kernel.
NetworkSpec Spec(NetworkSpec::Kind kind, bool layer_norm) {
  const int features = kind == NetworkSpec::Kind::kMlp ? 0 : 43;
  return {.kind = kind,
          .observation_size = 172,
          .num_actions = 4,
          .features = features,
          .hidden = {77, 64},
          .layer_norm = layer_norm,
          .schema = "test"};
}

/// The weights after some updates on the kernel in use. A large ε makes Adam's step smooth in the
/// gradient, so that rounding stays small in the weights.
std::vector<float> Train(const NetworkSpec& spec) {
  Dqn dqn({.network = spec,
           .target_update = TargetUpdate::kPolyak,
           .polyak = 0.1,
           .adam = {.epsilon = 0.1}});
  Rng rng(51);
  for (int i = 0; i < 3; ++i) dqn.Update(bench::RandomBatch(spec, 37, 0.5, rng));
  const auto weights = dqn.parameters();
  return {weights.begin(), weights.end()};
}

TEST_CASE("Updates on each kernel give the same weights up to rounding, and the same bits again") {
  for (const auto kind : {NetworkSpec::Kind::kMlp, NetworkSpec::Kind::kCandidateScorer}) {
    for (const bool layer_norm : {false, true}) {
      const NetworkSpec spec = Spec(kind, layer_norm);
      std::vector<float> expected;
      OnEachKernel([&] {
        const auto sut = Train(spec);
        if (expected.empty()) expected = sut;  // the baseline's
        double largest = 0.0;
        for (std::size_t i = 0; i < sut.size(); ++i)
          largest = std::max(largest, std::abs(double{sut[i]} - double{expected[i]}));
        CHECK(largest < 1e-5);
        CHECK(Train(spec) == sut);
      });
    }
  }
}

TEST_CASE("Every CPU has the baseline, and names are those of the variable") {
  CHECK(AvailableKernels().front() == Kernel::kBaseline);
  CHECK(NameOf(Kernel::kBaseline) == "baseline");
  CHECK(NameOf(Kernel::kAvx2) == "avx2");
  CHECK(NameOf(Kernel::kAvx512) == "avx512");
}

TEST_CASE("The kernel in use is the one that RONDA_KERNEL names, else the best") {
  const char* const wanted = std::getenv("RONDA_KERNEL");
  if (wanted == nullptr)
    CHECK(KernelInUse() == AvailableKernels().back());
  else
    CHECK(NameOf(KernelInUse()) == wanted);
}

}  // namespace
}  // namespace ronda
