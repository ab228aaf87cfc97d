#include "common/nn/activation.h"

namespace ronda {

template <typename Scalar>
void ReluForward(MatrixView<Scalar> x) {
  const std::size_t size = x.size();
  for (std::size_t i = 0; i < size; ++i) x.data[i] = x.data[i] < Scalar(0) ? Scalar(0) : x.data[i];
}

template <typename Scalar>
void ReluBackward(ConstMatrix<Scalar> y, MatrixView<Scalar> d) {
  const std::size_t size = d.size();
  // y = max(x, 0)   ⇒   ∂L/∂x = ∂L/∂y where y > 0, else 0
  for (std::size_t i = 0; i < size; ++i) d.data[i] = y.data[i] > Scalar(0) ? d.data[i] : Scalar(0);
}

template void ReluForward(MatrixView<float>);
template void ReluForward(MatrixView<double>);
template void ReluBackward(ConstMatrix<float>, MatrixView<float>);
template void ReluBackward(ConstMatrix<double>, MatrixView<double>);

}  // namespace ronda
