#include "common/nn/activation.h"

#include <type_traits>

#include "common/nn/loops.h"

namespace ronda {

template <typename Scalar>
void ReluForward(MatrixView<Scalar> x) {
  if constexpr (std::is_same_v<Scalar, float>)
    LoopsInUse().relu_forward(x.data, x.size());
  else
    ReluForwardLoop(x.data, x.size());
}

template <typename Scalar>
void ReluBackward(ConstMatrix<Scalar> y, MatrixView<Scalar> d) {
  if constexpr (std::is_same_v<Scalar, float>)
    LoopsInUse().relu_backward(y.data, d.data, d.size());
  else
    ReluBackwardLoop(y.data, d.data, d.size());
}

template void ReluForward(MatrixView<float>);
template void ReluForward(MatrixView<double>);
template void ReluBackward(ConstMatrix<float>, MatrixView<float>);
template void ReluBackward(ConstMatrix<double>, MatrixView<double>);

}  // namespace ronda
