#include "common/nn/gemm.h"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using testing::RandomVector;

constexpr GemmKernel kKernels[] = {GemmKernel::kEigen, GemmKernel::kTileBaseline,
                                   GemmKernel::kTileAvx2, GemmKernel::kTileAvx512};

enum class Start { kZero, kBias, kAccumulate };

/// One random product and what the definition gives for it, in double.
struct Case {
  std::vector<float> a, b, bias, c;
  std::vector<double> expected;
  Product<float> product;

  Case(int m, int n, int k, bool transposed, Start start, Rng& rng) {
    const auto size = [](int x, int y) {
      return static_cast<std::size_t>(x) * static_cast<std::size_t>(y);
    };
    a = RandomVector<float>(rng, size(m, k));
    b = RandomVector<float>(rng, size(k, n));
    bias = RandomVector<float>(rng, size(1, n));
    c = RandomVector<float>(rng, size(m, n));
    product = {.m = m,
               .n = n,
               .k = k,
               .a = a.data(),
               .a_row_stride = transposed ? 1 : k,
               .a_col_stride = transposed ? m : 1,
               .b = b.data(),
               .bias = start == Start::kBias ? bias.data() : nullptr,
               .accumulate = start == Start::kAccumulate,
               .c = c.data()};
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < n; ++j) {
        double sum = start == Start::kBias         ? bias[size(1, j)]
                     : start == Start::kAccumulate ? c[size(i, n) + size(1, j)]
                                                   : 0.0;
        for (int p = 0; p < k; ++p)
          sum += double{a[transposed ? size(p, m) + size(1, i) : size(i, k) + size(1, p)]} *
                 double{b[size(p, n) + size(1, j)]};
        expected.push_back(sum);
      }
    }
  }
};

TEST_CASE("Every kernel gives the defined product for all small and some large sizes") {
  Rng rng(11);
  std::vector<std::vector<int>> sizes;
  for (const int m : {0, 1, 2, 3, 5, 6, 7, 13})
    for (const int n : {1, 3, 4, 7, 8, 17, 31, 64, 130})
      for (const int k : {1, 2, 26}) sizes.push_back({m, n, k});
  sizes.push_back({128, 64, 64});
  sizes.push_back({65, 100, 33});
  int kernels_run = 0;
  for (const GemmKernel kernel : kKernels) {
    bool ran = false;
    for (const auto& size : sizes) {
      for (const bool transposed : {false, true}) {
        for (const Start start : {Start::kZero, Start::kBias, Start::kAccumulate}) {
          Case sut(size[0], size[1], size[2], transposed, start, rng);
          if (!MultiplyWith(kernel, sut.product)) continue;
          ran = true;
          double largest = 0.0;
          for (std::size_t i = 0; i < sut.c.size(); ++i)
            largest = std::max(largest, std::abs(sut.c[i] - sut.expected[i]));
          INFO("kernel " << static_cast<int>(kernel) << ", " << size[0] << " × " << size[1] << " × "
                         << size[2] << ", transposed " << transposed);
          REQUIRE(largest < 1e-4);
        }
      }
    }
    kernels_run += ran ? 1 : 0;
  }
  CHECK(kernels_run >= 2);  // Eigen and the baseline tile run everywhere
}

TEST_CASE("A row's product is the same bits alone and in a batch") {
  Rng rng(12);
  Case batch(128, 65, 64, false, Start::kBias, rng);
  Multiply(batch.product);
  for (const int row : {0, 5, 63, 127}) {
    std::vector<float> alone(65);
    Product<float> product = batch.product;
    product.m = 1;
    product.a += row * product.a_row_stride;
    product.c = alone.data();
    Multiply(product);
    const std::vector<float> in_batch(batch.c.begin() + row * 65, batch.c.begin() + (row + 1) * 65);
    CHECK(alone == in_batch);
  }
}

TEST_CASE("The product in double agrees with the definition") {
  const std::vector<double> a{1, 2, 3, 4, 5, 6};  // (2, 3)
  const std::vector<double> b{1, 0, 0, 1, 1, 1};  // (3, 2)
  std::vector<double> c(4);
  Multiply(Product<double>{.m = 2,
                           .n = 2,
                           .k = 3,
                           .a = a.data(),
                           .a_row_stride = 3,
                           .a_col_stride = 1,
                           .b = b.data(),
                           .c = c.data()});
  CHECK(c == std::vector<double>{4, 5, 10, 11});
}

}  // namespace
}  // namespace ronda
