#pragma once
// The fully connected layer y = x·w + b, and its derivative.
//
// Shapes: x (B, I), w (I, O), b (1, O), y (B, O). Sizes that disagree are a bug. Gradients of
// parameters are added to what is there, so that a batch can be split. Thread-safe; allocates
// nothing. Defined for float and double.
#include "common/nn/matrix.h"

namespace ronda {

enum class Activation { kNone, kRelu };

/// y = x·w + b, or max(x·w + b, 0) as activation.h in the same pass
template <typename Scalar>
void LinearForward(ConstMatrix<Scalar> x, ConstMatrix<Scalar> w, ConstMatrix<Scalar> b,
                   MatrixView<Scalar> y, Activation activation = Activation::kNone);

template <typename Scalar>
struct LinearGradient {
  MatrixView<Scalar> w;  // (I, O) added to
  MatrixView<Scalar> b;  // (1, O) added to
  MatrixView<Scalar> x;  // (B, I) overwritten; data = nullptr: not wanted
};

/// From dy = ∂L/∂y (B, O) to ∂L/∂w, ∂L/∂b, ∂L/∂x.
template <typename Scalar>
void LinearBackward(ConstMatrix<Scalar> x, ConstMatrix<Scalar> w, ConstMatrix<Scalar> dy,
                    const LinearGradient<Scalar>& gradient);

}  // namespace ronda
