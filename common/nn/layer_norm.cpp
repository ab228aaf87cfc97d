#include "common/nn/layer_norm.h"

#include <array>
#include <cmath>

#include "common/base/check.h"

namespace ronda {
namespace {

constexpr double kEpsilon = 1e-5;
constexpr int kLanes = 8;  // partial sums side by side, so that the compiler may use vectors

/// Σ term(c) over c = 0 … count − 1, always in the same order.
template <typename Scalar, typename Term>
Scalar Sum(int count, Term term) {
  std::array<Scalar, kLanes> lanes{};
  int c = 0;
  for (; c + kLanes <= count; c += kLanes)
    for (int lane = 0; lane < kLanes; ++lane)
      lanes[static_cast<std::size_t>(lane)] += term(c + lane);
  Scalar sum = 0;
  for (; c < count; ++c) sum += term(c);
  for (const Scalar lane : lanes) sum += lane;
  return sum;
}

}  // namespace

template <typename Scalar>
void LayerNormForward(ConstMatrix<Scalar> gain, ConstMatrix<Scalar> shift, MatrixView<Scalar> x,
                      MatrixView<Scalar> inverse_deviation, MatrixView<Scalar> y) {
  RONDA_CHECK(gain.cols == x.cols && shift.cols == x.cols && y.cols == x.cols,
              "{} columns, gain {}", x.cols, gain.cols);
  const int cols = x.cols;
  const Scalar share = Scalar(1) / static_cast<Scalar>(cols);
  for (int r = 0; r < x.rows; ++r) {
    Scalar* const in = x.row(r);
    Scalar* const out = y.row(r);
    const Scalar mean = share * Sum<Scalar>(cols, [&](int c) { return in[c]; });
    const Scalar variance =
        share * Sum<Scalar>(cols, [&](int c) { return (in[c] - mean) * (in[c] - mean); });
    const Scalar inverse = Scalar(1) / std::sqrt(variance + static_cast<Scalar>(kEpsilon));
    inverse_deviation.data[r] = inverse;
    for (int c = 0; c < cols; ++c) {
      in[c] = (in[c] - mean) * inverse;
      out[c] = gain.data[c] * in[c] + shift.data[c];
    }
  }
}

template <typename Scalar>
void LayerNormBackward(ConstMatrix<Scalar> gain, ConstMatrix<Scalar> normalised,
                       ConstMatrix<Scalar> inverse_deviation, MatrixView<Scalar> d,
                       const LayerNormGradient<Scalar>& gradient) {
  const int cols = d.cols;
  const Scalar share = Scalar(1) / static_cast<Scalar>(cols);
  for (int r = 0; r < d.rows; ++r) {
    Scalar* const dy = d.row(r);
    const Scalar* const x_hat = normalised.row(r);
    for (int c = 0; c < cols; ++c) {
      // y = gain·x̂ + shift   ⇒   ∂L/∂gain = Σ dy·x̂, ∂L/∂shift = Σ dy, ∂L/∂x̂ = dy·gain
      gradient.gain.data[c] += dy[c] * x_hat[c];
      gradient.shift.data[c] += dy[c];
      dy[c] *= gain.data[c];
    }
    // x̂ = (x − mean(x)) / √(var(x) + ε)
    //   ⇒   ∂L/∂x = (∂L/∂x̂ − mean(∂L/∂x̂) − x̂·mean(∂L/∂x̂·x̂)) / √(var(x) + ε)
    const Scalar mean = share * Sum<Scalar>(cols, [&](int c) { return dy[c]; });
    const Scalar along = share * Sum<Scalar>(cols, [&](int c) { return dy[c] * x_hat[c]; });
    const Scalar inverse = inverse_deviation.data[r];
    for (int c = 0; c < cols; ++c) dy[c] = (dy[c] - mean - x_hat[c] * along) * inverse;
  }
}

template void LayerNormForward(ConstMatrix<float>, ConstMatrix<float>, MatrixView<float>,
                               MatrixView<float>, MatrixView<float>);
template void LayerNormForward(ConstMatrix<double>, ConstMatrix<double>, MatrixView<double>,
                               MatrixView<double>, MatrixView<double>);
template void LayerNormBackward(ConstMatrix<float>, ConstMatrix<float>, ConstMatrix<float>,
                                MatrixView<float>, const LayerNormGradient<float>&);
template void LayerNormBackward(ConstMatrix<double>, ConstMatrix<double>, ConstMatrix<double>,
                                MatrixView<double>, const LayerNormGradient<double>&);

}  // namespace ronda
