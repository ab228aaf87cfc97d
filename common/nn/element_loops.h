#pragma once
// The element-wise loops behind the layers and Adam: over floats for each kernel, over doubles
// once.
//
// Included by loops.h and so by sources that are compiled with other instruction sets: everything
// has internal linkage or no code at all, and nothing of the standard library is instantiated (see
// gemm_tile.h). Written for the compiler's vectoriser: pointers that do not alias, sums side by
// side in a fixed number of lanes, so that a result does not depend on what is vectorised.
#include <cstddef>

namespace ronda {

/// x̂ = (x − mean)/√(variance + ε), y = gain·x̂ + shift. Shapes as layer_norm.h.
template <typename Scalar>
struct LayerNormRows {
  int rows;                   // B
  int cols;                   // C
  const Scalar* gain;         // (C)
  const Scalar* shift;        // (C)
  Scalar* x;                  // (B, C) becomes x̂
  Scalar* inverse_deviation;  // (B)
  Scalar* y;                  // (B, C)
};

/// d comes as ∂L/∂y and leaves as ∂L/∂x.
template <typename Scalar>
struct LayerNormSlopes {
  int rows;                         // B
  int cols;                         // C
  const Scalar* gain;               // (C)
  const Scalar* normalised;         // (B, C) x̂
  const Scalar* inverse_deviation;  // (B)
  Scalar* d;                        // (B, C)
  Scalar* gain_gradient;            // (C) added to
  Scalar* shift_gradient;           // (C) added to
};

/// θ ← θ − step·m / (√v·spread + ε) with m ← β1·m + (1 − β1)·g, v ← β2·v + (1 − β2)·g²: the bias
/// corrections are in `step` and `spread`.
template <typename Scalar>
struct AdamStep {
  std::size_t size;
  Scalar keep1, keep2;  // β
  Scalar take1, take2;  // 1 − β
  Scalar step, spread, epsilon;
  const Scalar* gradient;
  Scalar* m;
  Scalar* v;
  Scalar* parameters;
};

namespace {

[[maybe_unused]] inline float Root(float x) { return __builtin_sqrtf(x); }
[[maybe_unused]] inline double Root(double x) { return __builtin_sqrt(x); }

/// Σ term(i) over i = 0 … count − 1, always in the same order.
template <typename Sum, int kLanes, typename Index, typename Term>
inline Sum LaneSum(Index count, Term term) {
  Sum lanes[kLanes] = {};
  Index i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (int lane = 0; lane < kLanes; ++lane) lanes[lane] += term(i + static_cast<Index>(lane));
  Sum sum = 0;
  for (; i < count; ++i) sum += term(i);
  for (const Sum lane : lanes) sum += lane;
  return sum;
}

/// x becomes max(x, 0); what is not a number stays so.
template <typename Scalar>
inline void ReluForwardLoop(Scalar* x, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) x[i] = x[i] < Scalar(0) ? Scalar(0) : x[i];
}

/// y = max(x, 0)   ⇒   ∂L/∂x = ∂L/∂y where y > 0, else 0
template <typename Scalar>
inline void ReluBackwardLoop(const Scalar* __restrict y, Scalar* __restrict d, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) d[i] = y[i] > Scalar(0) ? d[i] : Scalar(0);
}

/// sum (cols) += Σ over the rows of x (rows, cols)
template <typename Scalar>
inline void AddRowsLoop(const Scalar* __restrict x, int rows, int cols, Scalar* __restrict sum) {
  for (int r = 0; r < rows; ++r, x += cols)
    for (int c = 0; c < cols; ++c) sum[c] += x[c];
}

template <typename Scalar>
inline void LayerNormForwardLoop(const LayerNormRows<Scalar>& rows) {
  const int cols = rows.cols;
  const Scalar* const __restrict gain = rows.gain;
  const Scalar* const __restrict shift = rows.shift;
  const Scalar share = Scalar(1) / static_cast<Scalar>(cols);
  for (int r = 0; r < rows.rows; ++r) {
    Scalar* const __restrict x = rows.x + static_cast<std::ptrdiff_t>(r) * cols;
    Scalar* const __restrict y = rows.y + static_cast<std::ptrdiff_t>(r) * cols;
    const Scalar mean = share * LaneSum<Scalar, 16>(cols, [&](int c) { return x[c]; });
    const Scalar variance =
        share * LaneSum<Scalar, 16>(cols, [&](int c) { return (x[c] - mean) * (x[c] - mean); });
    const Scalar inverse = Scalar(1) / Root(variance + static_cast<Scalar>(1e-5));
    rows.inverse_deviation[r] = inverse;
    for (int c = 0; c < cols; ++c) {
      x[c] = (x[c] - mean) * inverse;
      y[c] = gain[c] * x[c] + shift[c];
    }
  }
}

template <typename Scalar>
inline void LayerNormBackwardLoop(const LayerNormSlopes<Scalar>& slopes) {
  const int cols = slopes.cols;
  const Scalar* const __restrict gain = slopes.gain;
  Scalar* const __restrict gain_gradient = slopes.gain_gradient;
  Scalar* const __restrict shift_gradient = slopes.shift_gradient;
  const Scalar share = Scalar(1) / static_cast<Scalar>(cols);
  for (int r = 0; r < slopes.rows; ++r) {
    Scalar* const __restrict d = slopes.d + static_cast<std::ptrdiff_t>(r) * cols;
    const Scalar* const __restrict x_hat =
        slopes.normalised + static_cast<std::ptrdiff_t>(r) * cols;
    for (int c = 0; c < cols; ++c) {
      // y = gain·x̂ + shift   ⇒   ∂L/∂gain = Σ dy·x̂, ∂L/∂shift = Σ dy, ∂L/∂x̂ = dy·gain
      gain_gradient[c] += d[c] * x_hat[c];
      shift_gradient[c] += d[c];
      d[c] *= gain[c];
    }
    // x̂ = (x − mean(x)) / √(var(x) + ε)
    //   ⇒   ∂L/∂x = (∂L/∂x̂ − mean(∂L/∂x̂) − x̂·mean(∂L/∂x̂·x̂)) / √(var(x) + ε)
    const Scalar mean = share * LaneSum<Scalar, 16>(cols, [&](int c) { return d[c]; });
    const Scalar along = share * LaneSum<Scalar, 16>(cols, [&](int c) { return d[c] * x_hat[c]; });
    const Scalar inverse = slopes.inverse_deviation[r];
    for (int c = 0; c < cols; ++c) d[c] = (d[c] - mean - x_hat[c] * along) * inverse;
  }
}

/// Moments too small to move a weight become 0: those of a unit that gets no gradient would fade
/// into denormal numbers, on which a CPU is many times slower.
template <typename Scalar>
inline void AdamStepLoop(const AdamStep<Scalar>& a) {
  constexpr Scalar kTiny = static_cast<Scalar>(1e-30);
  const Scalar* const __restrict g = a.gradient;
  Scalar* const __restrict m = a.m;
  Scalar* const __restrict v = a.v;
  Scalar* const __restrict theta = a.parameters;
  const AdamStep<Scalar> k = a;  // a copy that no store can change
  for (std::size_t i = 0; i < k.size; ++i) {
    const Scalar next_m = k.keep1 * m[i] + k.take1 * g[i];
    const Scalar next_v = k.keep2 * v[i] + k.take2 * g[i] * g[i];
    m[i] = next_m < kTiny && next_m > -kTiny ? Scalar(0) : next_m;
    v[i] = next_v < kTiny ? Scalar(0) : next_v;
    theta[i] -= k.step * m[i] / (Root(v[i]) * k.spread + k.epsilon);
  }
}

template <typename Scalar>
inline double SumOfSquaresLoop(const Scalar* x, std::size_t size) {
  return LaneSum<double, 16>(size, [x](std::size_t i) {
    const double value = static_cast<double>(x[i]);
    return value * value;
  });
}

template <typename Scalar>
inline void ScaleLoop(Scalar* x, std::size_t size, Scalar factor) {
  for (std::size_t i = 0; i < size; ++i) x[i] *= factor;
}

/// x ← x + share·(goal − x)
template <typename Scalar>
inline void ApproachLoop(Scalar* __restrict x, const Scalar* __restrict goal, std::size_t size,
                         Scalar share) {
  for (std::size_t i = 0; i < size; ++i) x[i] += share * (goal[i] - x[i]);
}

}  // namespace
}  // namespace ronda
