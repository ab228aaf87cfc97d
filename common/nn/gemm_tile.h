#pragma once
// The register tile behind gemm.h, for sources that are compiled with one instruction set each.
//
// Included by loops_<kernel>.cpp only. Everything has internal linkage and nothing of the standard
// library is instantiated: the same inline function compiled with different -m flags would be
// merged by the linker into any one of them. A tile of kRows × kVectors vector registers stays in
// registers while k runs; Tile works on GCC's vector types and on the plain scalar alike. Where
// many rows read the same columns of B, those are first copied side by side, kDepth rows at a time,
// so that they stay in the first-level cache (Goto & van de Geijn 2008).
#include "common/nn/gemm.h"

namespace ronda {
namespace {

using Vector16 = float __attribute__((vector_size(16)));
using Vector32 = float __attribute__((vector_size(32)));
using Vector64 = float __attribute__((vector_size(64)));

constexpr int kDepth = 160;   // 64 columns of it are 40 KiB
constexpr int kFewRows = 12;  // too few to earn back a copy of B

/// Rows k_begin … k_begin + k_count − 1 of some columns of B.
struct Strip {
  const float* b;  // (k_count, width)
  std::ptrdiff_t row_stride;
  int k_begin;
  int k_count;
};

template <typename V, int kRows, int kVectors>
inline void Tile(const Product<float>& p, const Strip& strip, int row, int col) {
  constexpr int kLanes = sizeof(V) / sizeof(float);
  const bool resume = p.accumulate || strip.k_begin > 0;
  float* const c = p.c + static_cast<std::ptrdiff_t>(row) * p.n + col;
  V sum[kRows][kVectors];
#pragma GCC unroll 12
  for (int r = 0; r < kRows; ++r) {
#pragma GCC unroll 8
    for (int v = 0; v < kVectors; ++v) {
      if (resume)
        __builtin_memcpy(&sum[r][v], c + static_cast<std::ptrdiff_t>(r) * p.n + v * kLanes,
                         sizeof(V));
      else if (p.bias != nullptr)
        __builtin_memcpy(&sum[r][v], p.bias + col + v * kLanes, sizeof(V));
      else
        sum[r][v] = V{};
    }
  }
  const float* a = p.a + row * p.a_row_stride + strip.k_begin * p.a_col_stride;
  const float* b = strip.b;
  for (int k = 0; k < strip.k_count; ++k, a += p.a_col_stride, b += strip.row_stride) {
    V b_row[kVectors];
#pragma GCC unroll 8
    for (int v = 0; v < kVectors; ++v) __builtin_memcpy(&b_row[v], b + v * kLanes, sizeof(V));
#pragma GCC unroll 12
    for (int r = 0; r < kRows; ++r) {
      const float a_value = a[r * p.a_row_stride];
#pragma GCC unroll 8
      for (int v = 0; v < kVectors; ++v) sum[r][v] += a_value * b_row[v];
    }
  }
  const bool rectify = p.rectify && strip.k_begin + strip.k_count == p.k;
#pragma GCC unroll 12
  for (int r = 0; r < kRows; ++r) {
#pragma GCC unroll 8
    for (int v = 0; v < kVectors; ++v) {
      if (rectify) sum[r][v] = sum[r][v] < 0.0f ? V{} : sum[r][v];
      __builtin_memcpy(c + static_cast<std::ptrdiff_t>(r) * p.n + v * kLanes, &sum[r][v],
                       sizeof(V));
    }
  }
}

/// The rows from `row` on: as many tiles of kRows as fit, then lower ones.
template <typename V, int kRows, int kVectors>
inline void Rows(const Product<float>& p, const Strip& strip, int row, int col) {
  for (; row + kRows <= p.m; row += kRows) Tile<V, kRows, kVectors>(p, strip, row, col);
  if constexpr (kRows > 4)
    Rows<V, 4, kVectors>(p, strip, row, col);
  else if constexpr (kRows > 1)
    Rows<V, kRows / 2, kVectors>(p, strip, row, col);
}

/// Rows k_begin … of kWidth columns of B, side by side.
template <int kWidth>
inline void CopyStrip(const Product<float>& p, int k_begin, int k_count, int col, float* strip) {
  if (!p.b_transposed) {
    for (int k = 0; k < k_count; ++k)
      __builtin_memcpy(strip + k * kWidth,
                       p.b + static_cast<std::ptrdiff_t>(k_begin + k) * p.n + col,
                       kWidth * sizeof(float));
    return;
  }
  for (int j = 0; j < kWidth; ++j) {
    const float* const from = p.b + static_cast<std::ptrdiff_t>(col + j) * p.k + k_begin;
    for (int k = 0; k < k_count; ++k) strip[k * kWidth + j] = from[k];
  }
}

/// All rows of kVectors vectors' width from column `col` on.
template <typename V, int kRows, int kVectors>
inline void Column(const Product<float>& p, int col) {
  constexpr int kWidth = kVectors * static_cast<int>(sizeof(V) / sizeof(float));
  if (!p.b_transposed && (p.m <= kFewRows || p.n == kWidth)) {
    Rows<V, kRows, kVectors>(p, {p.b + col, p.n, 0, p.k}, 0, col);
    return;
  }
  alignas(64) float copy[kDepth * kWidth];
  for (int k = 0; k < p.k; k += kDepth) {
    const int count = p.k - k < kDepth ? p.k - k : kDepth;
    CopyStrip<kWidth>(p, k, count, col, copy);
    Rows<V, kRows, kVectors>(p, {copy, kWidth, k, count}, 0, col);
  }
}

/// The whole product: wide columns first, then single vectors, shorter vectors, scalars. A tile of
/// one vector has twice the rows, so that enough sums are under way. kRows: 4 … 6.
template <typename V, int kRows, int kVectors>
inline void MultiplyTiled(const Product<float>& p) {
  constexpr int kLanes = sizeof(V) / sizeof(float);
  int col = 0;
  if (p.m <= 2)  // few rows: wider tiles, to the same end
    for (; col + 2 * kVectors * kLanes <= p.n; col += 2 * kVectors * kLanes)
      Column<V, 2, 2 * kVectors>(p, col);
  for (; col + kVectors * kLanes <= p.n; col += kVectors * kLanes)
    Column<V, kRows, kVectors>(p, col);
  for (; col + kLanes <= p.n; col += kLanes) Column<V, 2 * kRows, 1>(p, col);
  if constexpr (kLanes > 8)
    for (; col + 8 <= p.n; col += 8) Column<Vector32, 2 * kRows, 1>(p, col);
  if constexpr (kLanes > 4)
    for (; col + 4 <= p.n; col += 4) Column<Vector16, 2 * kRows, 1>(p, col);
  for (; col < p.n; ++col) Column<float, 2 * kRows, 1>(p, col);
}

}  // namespace
}  // namespace ronda
