#pragma once
// C (M, N) = A (M, K) · B (K, N) + start: the one product that every layer is made of.
//
// A is read with strides and B as it lies or transposed, so Aᵀ and Bᵀ cost nothing to the caller; C
// is packed row-major. Double goes to Eigen, the reference. Float goes to a register tile
// (gemm_tile.h) on the kernel in use (kernel.h). A tile sums in the order of k, so the result
// depends on the kernel but not on M: a row has the same value alone and in a batch. Sizes ≥ 0,
// K ≥ 1. Thread-safe; allocates nothing (40 KiB of stack).
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
  const Scalar* b = nullptr;        // (K, N) packed; (N, K) packed where transposed
  bool b_transposed = false;
  const Scalar* bias = nullptr;  // (N) added to every row; nullptr: none
  bool accumulate = false;       // add to what C holds; not together with a bias
  bool rectify = false;          // max(result, 0); what is not a number stays so
  Scalar* c = nullptr;           // (M, N)
};

void Multiply(const Product<float>& product);
void Multiply(const Product<double>& product);

}  // namespace ronda
