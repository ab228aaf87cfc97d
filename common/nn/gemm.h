#pragma once
// C (M, N) = A (M, K) · B (K, N) + start: the one product that every layer is made of.
//
// A is read with strides, so Aᵀ costs nothing; B and C are packed row-major. Two implementations:
// Eigen (any scalar, any CPU; compiled for the baseline instruction set), and for float on CPUs
// with AVX2 or AVX-512 a register tile (gemm_tile.h), chosen once at run time. The tile accumulates
// in the order of k, so the result depends on the instruction set but not on M: a row has the same
// value alone and in a batch. Thread-safe; no allocation in the tile.
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
