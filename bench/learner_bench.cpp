// How fast the learner updates and the actor decides, against references in the same run.
//
//   learner_bench [rounds, default 15] [seconds for each figure and round, default 0.1]
//
// The update is Double DQN's on a perceptron 160-128-128-8, whole: from the mini-batch to the new
// weights. Its floating-point operations are those of the matrix products alone, a multiplication
// and an addition each; bias, ReLU, loss, clipping and Adam count as time, not as work:
//
//   2·B·(5·W − I·H),  W = 160·128 + 128·128 + 128·8 weights, I·H = 160·128
//
// three forward passes (online on s and s', target on s'), backward to the weights, backward to the
// inputs of all layers but the first. References: OpenBLAS's sgemm, and the same update in Eigen's
// own expressions without -m flags. Reference and subject take turns; figures are medians over the
// rounds. Then the scorer's update and decisions. Prints figures; asserts only that both updates
// agree. RONDA_KERNEL chooses the kernel.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <exception>

#include "bench/decision_figures.h"
#include "bench/eigen_dqn.h"
#include "bench/random_batch.h"
#include "bench/rounds.h"
#include "bench/sgemm.h"
#include "common/nn/kernel.h"
#include "learner/dqn.h"

namespace ronda::bench {
namespace {

constexpr int kInputs = 160, kWidth = 128, kActions = 8;
constexpr std::uint64_t kNever = 1'000'000'000'000;  // updates between copies of the target

NetworkSpec Perceptron() {
  return {.kind = NetworkSpec::Kind::kMlp,
          .observation_size = kInputs,
          .num_actions = kActions,
          .hidden = {kWidth, kWidth},
          .schema = "bench"};
}

NetworkSpec Scorer() {
  return {.kind = NetworkSpec::Kind::kCandidateScorer,
          .observation_size = 4 * 26,
          .num_actions = 4,
          .features = 26,
          .hidden = {64, 64},
          .schema = "bench"};
}

double UpdateFlop(std::uint32_t batch_size) {
  constexpr double kWeights = kInputs * kWidth + kWidth * kWidth + kWidth * kActions;
  return 2.0 * batch_size * (5.0 * kWeights - kInputs * kWidth);
}

std::vector<SampledBatch> Batches(const NetworkSpec& spec, std::uint32_t count, double legal) {
  Rng rng(1);
  std::vector<SampledBatch> batches;
  for (int i = 0; i < 20; ++i) batches.push_back(RandomBatch(spec, count, legal, rng));
  return batches;
}

/// Both updates must be the same computation, or their ratio says nothing.
void CheckAgreement(const DqnConfig& config, const std::vector<SampledBatch>& batches) {
  Dqn dqn(config);
  EigenDqn reference(config, dqn.parameters());
  for (const SampledBatch& batch : batches) {
    const double loss = dqn.Update(batch).loss;
    const double expected = reference.Update(batch);
    if (std::abs(loss - expected) > 1e-3 * expected) {
      fmt::print(stderr, "learner_bench: loss {} but Eigen's is {}\n", loss, expected);
      std::abort();
    }
  }
}

void PrintUpdateFigures(const Sgemm& sgemm, double slice_s, int rounds) {
  fmt::print("Double-DQN update of a perceptron {0}-{1}-{1}-{2}\n", kInputs, kWidth, kActions);
  for (const std::uint32_t batch_size : {32u, 256u, 512u}) {
    const DqnConfig config{.network = Perceptron(), .target_interval = kNever};
    const auto batches = Batches(config.network, batch_size, 1.0);
    CheckAgreement(config, batches);
    Dqn dqn(config);
    EigenDqn eigen(config, dqn.parameters());
    std::size_t turn = 0;
    std::vector<std::function<void()>> calls = {
        [&] { dqn.Update(batches[turn++ % batches.size()]); },
        [&] { eigen.Update(batches[turn++ % batches.size()]); }};
    if (sgemm.call) calls.push_back(sgemm.call);
    const auto rates = MeasureInTurn(slice_s, rounds, calls);
    const double flop = UpdateFlop(batch_size);
    fmt::print(
        "  B = {:<4} {:8.0f} updates/s  {:6.1f} GFLOP/s ({:.2f} MFLOP each)  {:5.2f} × Eigen",
        batch_size, Median(rates[0]), Median(rates[0]) * flop / 1e9, flop / 1e6,
        MedianRatio(rates[0], rates[1]));
    if (sgemm.call)
      fmt::print("  {:.3f} of sgemm at {:.1f} GFLOP/s",
                 MedianRatio(rates[0], rates[2]) * flop / kSgemmFlop,
                 Median(rates[2]) * kSgemmFlop / 1e9);
    fmt::print("\n");
  }
}

void PrintScorerUpdate(double slice_s, int rounds) {
  const DqnConfig config{.network = Scorer()};
  const auto batches = Batches(config.network, 128, 0.4);  // 2.2 of 4 actions legal on average
  Dqn dqn(config);
  std::size_t turn = 0;
  const auto rates =
      MeasureInTurn(slice_s, rounds, {[&] { dqn.Update(batches[turn++ % batches.size()]); }});
  fmt::print("scorer 26-64-64-1, B = 128: {:.0f} updates/s\n", Median(rates[0]));
}

int Run(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  const double slice_s = argc > 2 ? std::atof(argv[2]) : 0.1;
  const Sgemm sgemm = MakeSgemm();
  fmt::print("kernel {}; OpenBLAS {}; {} rounds of {} s\n", NameOf(KernelInUse()), sgemm.name,
             rounds, slice_s);
  PrintUpdateFigures(sgemm, slice_s, rounds);
  PrintScorerUpdate(slice_s, rounds);
  PrintDecisionFigures("cumberland", 10, slice_s, rounds);
  return 0;
}

}  // namespace
}  // namespace ronda::bench

int main(int argc, char** argv) {
  try {
    return ronda::bench::Run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "learner_bench: {}\n", error.what());
    return 1;
  }
}
