#pragma once
// Layer normalisation: each row to mean 0 and variance 1, then a gain and a shift for each column.
//
// x̂ = (x − mean(x)) / √(var(x) + 1e-5), y = gain·x̂ + shift; var is the mean squared deviation.
// Thread-safe; float and double. Source: Ba, Kiros & Hinton 2016.
#include "common/nn/matrix.h"

namespace ronda {

/// x (B, C) becomes x̂; `inverse_deviation` (B, 1) and y (B, C) are written. Gain and shift: (1, C).
template <typename Scalar>
void LayerNormForward(ConstMatrix<Scalar> gain, ConstMatrix<Scalar> shift, MatrixView<Scalar> x,
                      MatrixView<Scalar> inverse_deviation, MatrixView<Scalar> y);

template <typename Scalar>
struct LayerNormGradient {
  MatrixView<Scalar> gain;   // (1, C) added to
  MatrixView<Scalar> shift;  // (1, C) added to
};

/// d (B, C) comes as ∂L/∂y and leaves as ∂L/∂x; `normalised` is the x̂ that the forward pass left.
template <typename Scalar>
void LayerNormBackward(ConstMatrix<Scalar> gain, ConstMatrix<Scalar> normalised,
                       ConstMatrix<Scalar> inverse_deviation, MatrixView<Scalar> d,
                       const LayerNormGradient<Scalar>& gradient);

}  // namespace ronda
