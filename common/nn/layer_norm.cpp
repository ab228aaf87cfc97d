#include "common/nn/layer_norm.h"

#include <type_traits>

#include "common/base/check.h"
#include "common/nn/loops.h"

namespace ronda {

template <typename Scalar>
void LayerNormForward(ConstMatrix<Scalar> gain, ConstMatrix<Scalar> shift, MatrixView<Scalar> x,
                      MatrixView<Scalar> inverse_deviation, MatrixView<Scalar> y) {
  RONDA_CHECK(gain.cols == x.cols && shift.cols == x.cols && y.cols == x.cols,
              "{} columns, gain {}", x.cols, gain.cols);
  const LayerNormRows<Scalar> rows{.rows = x.rows,
                                   .cols = x.cols,
                                   .gain = gain.data,
                                   .shift = shift.data,
                                   .x = x.data,
                                   .inverse_deviation = inverse_deviation.data,
                                   .y = y.data};
  if constexpr (std::is_same_v<Scalar, float>)
    LoopsInUse().layer_norm_forward(rows);
  else
    LayerNormForwardLoop(rows);
}

template <typename Scalar>
void LayerNormBackward(ConstMatrix<Scalar> gain, ConstMatrix<Scalar> normalised,
                       ConstMatrix<Scalar> inverse_deviation, MatrixView<Scalar> d,
                       const LayerNormGradient<Scalar>& gradient) {
  const LayerNormSlopes<Scalar> slopes{.rows = d.rows,
                                       .cols = d.cols,
                                       .gain = gain.data,
                                       .normalised = normalised.data,
                                       .inverse_deviation = inverse_deviation.data,
                                       .d = d.data,
                                       .gain_gradient = gradient.gain.data,
                                       .shift_gradient = gradient.shift.data};
  if constexpr (std::is_same_v<Scalar, float>)
    LoopsInUse().layer_norm_backward(slopes);
  else
    LayerNormBackwardLoop(slopes);
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
