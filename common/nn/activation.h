#pragma once
// The rectifier y = max(x, 0), in place, and its derivative. Thread-safe; float and double.
#include "common/nn/matrix.h"

namespace ronda {

/// x becomes max(x, 0); what is not a number stays so, and is seen in the loss.
template <typename Scalar>
void ReluForward(MatrixView<Scalar> x);

/// d comes as ∂L/∂y and leaves as ∂L/∂x; `y` is what the forward pass left. The slope at 0 is 0.
template <typename Scalar>
void ReluBackward(ConstMatrix<Scalar> y, MatrixView<Scalar> d);

}  // namespace ronda
