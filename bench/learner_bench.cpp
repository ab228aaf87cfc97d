// How fast the learner updates and the policy decides, against plain references in the same run.
//
//   learner_bench [seconds for each figure, default 1]
//
// The network is the per-candidate scorer 26-64-64-1 on 4 actions, 2.2 of them legal on average, at
// a batch of 128. The references do the same matrix products and nothing else: plain triple loops
// (compiled like everything here), and Eigen at the baseline instruction set. Prints figures and
// ratios; asserts nothing.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "common/nn/gemm.h"
#include "common/policies/q_policy.h"
#include "learner/dqn.h"

namespace {

using namespace ronda;

constexpr int kFeatures = 26;
constexpr int kWidth = 64;
constexpr int kActions = 4;
constexpr std::uint32_t kBatch = 128;
constexpr int kObservations = 1000;

NetworkSpec Spec() {
  return {.kind = NetworkSpec::Kind::kCandidateScorer,
          .observation_size = kActions * kFeatures,
          .num_actions = kActions,
          .features = kFeatures,
          .hidden = {kWidth, kWidth},
          .schema = "bench"};
}

/// Calls a second, for the best of five rounds.
template <typename Call>
double Rate(double seconds, Call call) {
  double best = 0.0;
  for (int round = 0; round < 5; ++round) {
    const auto start = std::chrono::steady_clock::now();
    double elapsed_s = 0.0;
    long calls = 0;
    do {
      for (int i = 0; i < 16; ++i) call();
      calls += 16;
      elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    } while (elapsed_s < seconds / 5);
    best = std::max(best, static_cast<double>(calls) / elapsed_s);
  }
  return best;
}

/// One legal action, then each other with probability 0.4: 2.2 on average.
std::vector<std::uint8_t> RandomLegal(Rng& rng, std::size_t rows) {
  std::vector<std::uint8_t> legal(rows * kActions);
  for (std::size_t r = 0; r < rows; ++r) {
    const std::uint32_t sure = rng.Below(kActions);
    for (std::uint32_t a = 0; a < kActions; ++a)
      legal[r * kActions + a] = a == sure || rng.Uniform() < 0.4 ? 1 : 0;
  }
  return legal;
}

std::vector<float> RandomFloats(Rng& rng, std::size_t size) {
  std::vector<float> values(size);
  for (float& value : values) value = static_cast<float>(rng.Normal());
  return values;
}

SampledBatch RandomBatch(Rng& rng) {
  SampledBatch batch;
  batch.shape = {.observation_size = kActions * kFeatures, .num_actions = kActions};
  batch.count = kBatch;
  batch.observations = RandomFloats(rng, kBatch * kActions * kFeatures);
  batch.next_observations = RandomFloats(rng, kBatch * kActions * kFeatures);
  batch.rewards = RandomFloats(rng, kBatch);
  batch.discounts.assign(kBatch, 0.9f);
  batch.next_legal_actions = RandomLegal(rng, kBatch);
  for (std::uint32_t i = 0; i < kBatch; ++i)
    batch.actions.push_back(static_cast<std::int32_t>(rng.Below(kActions)));
  batch.importance_weights.assign(kBatch, 1.0f);
  return batch;
}

void MultiplyPlain(const Product<float>& p) {
  for (int i = 0; i < p.m; ++i) {
    for (int j = 0; j < p.n; ++j) {
      float sum = 0.0f;
      for (int k = 0; k < p.k; ++k)
        sum += p.a[i * p.a_row_stride + k * p.a_col_stride] * p.b[k * p.n + j];
      p.c[i * p.n + j] = sum;
    }
  }
}

/// The products of the layers for a number of rows, forward and, if wanted, backward.
template <typename Multiplier>
class Products {
 public:
  explicit Products(Multiplier multiply) : multiply_(multiply) {}

  void Forward(int rows) {
    Run(rows, kWidth, kFeatures, false);
    Run(rows, kWidth, kWidth, false);
    Run(rows, 1, kWidth, false);
  }
  void Backward(int rows) {
    Run(kWidth, 1, rows, true);
    Run(rows, kWidth, 1, false);
    Run(kWidth, kWidth, rows, true);
    Run(rows, kWidth, kWidth, false);
    Run(kFeatures, kWidth, rows, true);
  }

 private:
  void Run(int m, int n, int k, bool transposed) {
    multiply_(Product<float>{.m = m,
                             .n = n,
                             .k = k,
                             .a = a_.data(),
                             .a_row_stride = transposed ? 1 : k,
                             .a_col_stride = transposed ? m : 1,
                             .b = b_.data(),
                             .c = c_.data()});
  }

  static constexpr std::size_t kRoom = std::size_t{kBatch} * kActions * kWidth;
  Multiplier multiply_;
  std::vector<float> a_ = std::vector<float>(kRoom, 0.5f);
  std::vector<float> b_ = std::vector<float>(kRoom, 0.25f);
  std::vector<float> c_ = std::vector<float>(kRoom);
};

void Print(const char* what, double rate, double reference) {
  fmt::print("{:<58} {:>12.0f} /s   × {:.2f}\n", what, rate, rate / reference);
}

void UpdateFigures(double seconds) {
  Rng rng(1);
  std::vector<SampledBatch> batches;
  for (int i = 0; i < 50; ++i) batches.push_back(RandomBatch(rng));
  const int next_rows = static_cast<int>(
      std::count(batches[0].next_legal_actions.begin(), batches[0].next_legal_actions.end(), 1));
  const auto products = [&](auto multiply) {
    return [sut = Products(multiply), next_rows]() mutable {
      sut.Forward(next_rows);
      sut.Forward(kBatch);
      sut.Forward(kBatch);
      sut.Backward(kBatch);
    };
  };
  const double plain = Rate(seconds, products([](const auto& p) { MultiplyPlain(p); }));
  Print("update's products alone, plain loops", plain, plain);
  Print("update's products alone, Eigen (baseline instructions)",
        Rate(seconds, products([](const auto& p) { (void)MultiplyWith(GemmKernel::kEigen, p); })),
        plain);
  Print("update's products alone, the kernel of this CPU",
        Rate(seconds, products([](const auto& p) { Multiply(p); })), plain);
  Dqn dqn({.network = Spec()});
  std::size_t turn = 0;
  Print("Dqn::Update, whole, batch 128",
        Rate(seconds, [&] { dqn.Update(batches[turn++ % batches.size()]); }), plain);
}

void DecisionFigures(double seconds) {
  Rng rng(2);
  const auto observations = RandomFloats(rng, kObservations * kActions * kFeatures);
  const auto legal = RandomLegal(rng, kObservations);
  const QNetwork<float> network(Spec());
  WeightSnapshot snapshot{.architecture_hash = network.architecture_hash(),
                          .values = std::vector<float>(network.parameter_count())};
  network.Initialise(rng, snapshot.values);
  QPolicy policy(Spec());
  if (policy.Load(snapshot) != LoadResult::kLoaded) std::abort();
  std::size_t turn = 0;
  long sum = 0;
  const auto products = [&](auto multiply) {
    return [&, sut = Products(multiply)]() mutable {
      const auto row =
          legal.begin() + static_cast<std::ptrdiff_t>(turn++ % kObservations * kActions);
      sut.Forward(static_cast<int>(std::count(row, row + kActions, 1)));
    };
  };
  const double plain = Rate(seconds, products([](const auto& p) { MultiplyPlain(p); }));
  Print("decision's products alone, plain loops", plain, plain);
  Print("decision's products alone, Eigen (baseline instructions)",
        Rate(seconds, products([](const auto& p) { (void)MultiplyWith(GemmKernel::kEigen, p); })),
        plain);
  Print("decision's products alone, tile at baseline instructions",
        Rate(seconds,
             products([](const auto& p) { (void)MultiplyWith(GemmKernel::kTileBaseline, p); })),
        plain);
  Print(
      "QPolicy::Act, whole",
      Rate(seconds,
           [&] {
             const std::size_t row = turn++ % kObservations;
             sum += policy.Act(
                 std::span(observations).subspan(row * kActions * kFeatures, kActions * kFeatures),
                 std::span(legal).subspan(row * kActions, kActions));
           }),
      plain);
  if (sum < 0) std::abort();  // the actions are used
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 1.0;
  fmt::print("kernel {} (0 Eigen, 1 tile, 2 tile AVX2, 3 tile AVX-512); × is against plain loops\n",
             static_cast<int>(BestGemmKernel()));
  UpdateFigures(seconds);
  DecisionFigures(seconds);
}
