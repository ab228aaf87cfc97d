#pragma once
// C (M, N) = A (M, K) · B (K, N) + start: the one product that every layer is made of.
//
// A is read with strides, so Aᵀ costs nothing; B and C are packed row-major. Double goes to Eigen.
// Float goes to a register tile (gemm_tile.h) compiled for three instruction sets, of which the
// CPU's best is chosen once at run time: Eigen could only be compiled for one, and at the baseline
// it is a fifth as fast where there is AVX-512 and half as fast on a decision's few rows
// (bench/learner_bench prints the ratios). A tile sums in the order of k, so the result depends on
// the instruction set but not on M: a row has the same value alone and in a batch. Sizes ≥ 0, K
// ≥ 1. Thread-safe; the tile allocates nothing.
#include <cstddef>

namespace ronda {

template <typename Scalar>
struct Product {
  int m = 0;
  int n = 0;
  int k = 0;
  const Scalar* a = nullptr;  // A(i, p) = a[i·a_row_stride + p·a_col_stride]
  std::ptrdiff_t a_row_stride = 0;
  std::ptrdiff_t a_col_stride = 1;  // one of the two strides is 1
  const Scalar* b = nullptr;        // (K, N)
  const Scalar* bias = nullptr;     // (N) added to every row; nullptr: none
  bool accumulate = false;          // add to what C holds; not together with a bias
  Scalar* c = nullptr;              // (M, N)
};

/// The fastest that this CPU has.
void Multiply(const Product<float>& product);
void Multiply(const Product<double>& product);

enum class GemmKernel { kEigen, kTileBaseline, kTileAvx2, kTileAvx512 };

/// What Multiply uses for float on this CPU.
GemmKernel BestGemmKernel();

/// A named kernel, for tests and benchmarks; false (and C untouched) where the CPU lacks it.
[[nodiscard]] bool MultiplyWith(GemmKernel kernel, const Product<float>& product);

}  // namespace ronda
