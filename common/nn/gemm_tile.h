#pragma once
// The register tile behind gemm.h, for sources that are compiled with one instruction set each.
//
// Included by gemm_<instruction set>.cpp only. Everything has internal linkage and nothing of the
// standard library is instantiated: the same inline function compiled with different -m flags would
// be merged by the linker into any one of them. A tile of kRows × kVectors vector registers stays
// in registers while k runs; Tile works on GCC's vector types and on the plain scalar alike.
#include "common/nn/gemm.h"

namespace ronda {
namespace {

using Vector16 = float __attribute__((vector_size(16)));
using Vector32 = float __attribute__((vector_size(32)));
using Vector64 = float __attribute__((vector_size(64)));

template <typename V, int kRows, int kVectors>
inline void Tile(const Product<float>& p, int row, int col) {
  constexpr int kLanes = sizeof(V) / sizeof(float);
  V sum[kRows][kVectors];
#pragma GCC unroll 8
  for (int r = 0; r < kRows; ++r) {
#pragma GCC unroll 8
    for (int v = 0; v < kVectors; ++v) {
      const int j = col + v * kLanes;
      if (p.accumulate)
        __builtin_memcpy(&sum[r][v], p.c + static_cast<std::ptrdiff_t>(row + r) * p.n + j,
                         sizeof(V));
      else if (p.bias != nullptr)
        __builtin_memcpy(&sum[r][v], p.bias + j, sizeof(V));
      else
        sum[r][v] = V{};
    }
  }
  const float* a = p.a + row * p.a_row_stride;
  const float* b = p.b + col;
  for (int k = 0; k < p.k; ++k, a += p.a_col_stride, b += p.n) {
    V b_row[kVectors];
#pragma GCC unroll 8
    for (int v = 0; v < kVectors; ++v) __builtin_memcpy(&b_row[v], b + v * kLanes, sizeof(V));
#pragma GCC unroll 8
    for (int r = 0; r < kRows; ++r) {
      const float a_value = a[r * p.a_row_stride];
#pragma GCC unroll 8
      for (int v = 0; v < kVectors; ++v) sum[r][v] += a_value * b_row[v];
    }
  }
#pragma GCC unroll 8
  for (int r = 0; r < kRows; ++r)
#pragma GCC unroll 8
    for (int v = 0; v < kVectors; ++v)
      __builtin_memcpy(p.c + static_cast<std::ptrdiff_t>(row + r) * p.n + col + v * kLanes,
                       &sum[r][v], sizeof(V));
}

/// All rows of kVectors vectors' width from column `col` on.
template <typename V, int kRows, int kVectors>
inline void Column(const Product<float>& p, int col) {
  int row = 0;
  for (; row + kRows <= p.m; row += kRows) Tile<V, kRows, kVectors>(p, row, col);
  if constexpr (kRows > 4) {
    if (row + 4 <= p.m) {
      Tile<V, 4, kVectors>(p, row, col);
      row += 4;
    }
  }
  if (row + 2 <= p.m) {
    Tile<V, 2, kVectors>(p, row, col);
    row += 2;
  }
  if (row < p.m) Tile<V, 1, kVectors>(p, row, col);
}

/// The whole product: wide columns first, then single vectors, shorter vectors, scalars. kRows: 4
/// … 7.
template <typename V, int kRows, int kVectors>
inline void MultiplyTiled(const Product<float>& p) {
  constexpr int kLanes = sizeof(V) / sizeof(float);
  int col = 0;
  if (p.m <= 2)  // few rows: wider tiles, so that enough sums are under way
    for (; col + 2 * kVectors * kLanes <= p.n; col += 2 * kVectors * kLanes)
      Column<V, 2, 2 * kVectors>(p, col);
  for (; col + kVectors * kLanes <= p.n; col += kVectors * kLanes)
    Column<V, kRows, kVectors>(p, col);
  for (; col + kLanes <= p.n; col += kLanes) Column<V, kRows, 1>(p, col);
  if constexpr (kLanes > 8)
    for (; col + 8 <= p.n; col += 8) Column<Vector32, kRows, 1>(p, col);
  if constexpr (kLanes > 4)
    for (; col + 4 <= p.n; col += 4) Column<Vector16, kRows, 1>(p, col);
  for (; col < p.n; ++col) Column<float, kRows, 1>(p, col);
}

}  // namespace
}  // namespace ronda
