#include "common/nn/gemm.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/unit/each_kernel.h"
#include "tests/unit/gradient_check.h"

namespace ronda {
namespace {

using testing::OnEachKernel;
using testing::RandomVector;

enum class Start { kZero, kBias, kAccumulate };

struct Form {
  bool a_transposed = false;
  bool b_transposed = false;
  Start start = Start::kZero;
  bool rectify = false;
};

/// One random product and what the definition gives for it, in double.
template <typename Scalar>
struct Case {
  std::vector<Scalar> a, b, bias, c;
  std::vector<double> expected;
  Product<Scalar> product;

  Case(int m, int n, int k, const Form& form, Rng& rng) {
    const auto size = [](int x, int y) {
      return static_cast<std::size_t>(x) * static_cast<std::size_t>(y);
    };
    a = RandomVector<Scalar>(rng, size(m, k));
    b = RandomVector<Scalar>(rng, size(k, n));
    bias = RandomVector<Scalar>(rng, size(1, n));
    c = RandomVector<Scalar>(rng, size(m, n));
    product = {.m = m,
               .n = n,
               .k = k,
               .a = a.data(),
               .a_row_stride = form.a_transposed ? 1 : k,
               .a_col_stride = form.a_transposed ? m : 1,
               .b = b.data(),
               .b_transposed = form.b_transposed,
               .bias = form.start == Start::kBias ? bias.data() : nullptr,
               .accumulate = form.start == Start::kAccumulate,
               .rectify = form.rectify,
               .c = c.data()};
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < n; ++j) {
        double sum = form.start == Start::kBias         ? double{bias[size(1, j)]}
                     : form.start == Start::kAccumulate ? double{c[size(i, n) + size(1, j)]}
                                                        : 0.0;
        for (int p = 0; p < k; ++p)
          sum += double{a[form.a_transposed ? size(p, m) + size(1, i) : size(i, k) + size(1, p)]} *
                 double{b[form.b_transposed ? size(j, k) + size(1, p) : size(p, n) + size(1, j)]};
        expected.push_back(form.rectify ? std::max(sum, 0.0) : sum);
      }
    }
  }

  double LargestError() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i)
      largest = std::max(largest, std::abs(double{c[i]} - expected[i]));
    return largest;
  }
};

constexpr Form kForms[] = {{.start = Start::kBias},
                           {.start = Start::kBias, .rectify = true},
                           {.a_transposed = true, .start = Start::kAccumulate},
                           {.a_transposed = true, .start = Start::kAccumulate, .rectify = true},
                           {.b_transposed = true},
                           {.a_transposed = true, .b_transposed = true, .rectify = true}};

/// (M, N, K)
std::vector<std::array<int, 3>> Sizes() {
  std::vector<std::array<int, 3>> sizes;
  for (const int m : {0, 1, 2, 3, 5, 6, 7, 13, 29})
    for (const int n : {1, 3, 4, 7, 8, 17, 31, 64, 130})
      for (const int k : {1, 2, 26}) sizes.push_back({m, n, k});
  sizes.insert(
      sizes.end(),
      {{128, 64, 64}, {65, 100, 33}, {40, 130, 160}, {40, 67, 161}, {13, 128, 401}, {3, 72, 401}});
  return sizes;
}

TEST_CASE("Every kernel gives the defined product for all small and some large sizes") {
  OnEachKernel([] {
    Rng rng(11);
    for (const auto& [m, n, k] : Sizes()) {
      for (const Form& form : kForms) {
        Case<float> sut(m, n, k, form, rng);
        Multiply(sut.product);
        INFO(m << " × " << n << " × " << k << ", form " << &form - kForms);
        REQUIRE(sut.LargestError() < 2e-4);
      }
    }
  });
}

TEST_CASE("The product in double is the defined one in every form") {
  Rng rng(13);
  for (const Form& form : kForms) {
    Case<double> sut(7, 17, 26, form, rng);
    Multiply(sut.product);
    INFO("form " << &form - kForms);
    CHECK(sut.LargestError() < 1e-12);
  }
}

TEST_CASE("A row's product is the same bits alone and in a batch, on every kernel") {
  OnEachKernel([] {
    Rng rng(12);
    Case<float> batch(128, 77, 170, {.start = Start::kBias}, rng);
    Multiply(batch.product);
    for (const int row : {0, 5, 63, 127}) {
      std::vector<float> alone(77);
      Product<float> product = batch.product;
      product.m = 1;
      product.a += row * product.a_row_stride;
      product.c = alone.data();
      Multiply(product);
      const std::vector<float> in_batch(batch.c.begin() + row * 77,
                                        batch.c.begin() + (row + 1) * 77);
      CHECK(alone == in_batch);
    }
  });
}

TEST_CASE("What is not a number stays so where the product is rectified") {
  const std::vector<float> a{std::numeric_limits<float>::quiet_NaN()}, b(20, 1.0f);
  OnEachKernel([&] {
    std::vector<float> c(20);
    Multiply(Product<float>{.m = 1,
                            .n = 20,
                            .k = 1,
                            .a = a.data(),
                            .a_row_stride = 1,
                            .b = b.data(),
                            .rectify = true,
                            .c = c.data()});
    for (const float value : c) CHECK(std::isnan(value));
  });
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
