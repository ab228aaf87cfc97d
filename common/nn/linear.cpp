#include "common/nn/linear.h"

#include <type_traits>

#include "common/base/check.h"
#include "common/nn/gemm.h"
#include "common/nn/loops.h"

namespace ronda {

template <typename Scalar>
void LinearForward(ConstMatrix<Scalar> x, ConstMatrix<Scalar> w, ConstMatrix<Scalar> b,
                   MatrixView<Scalar> y, Activation activation) {
  RONDA_CHECK(x.cols == w.rows && w.cols == y.cols && b.cols == w.cols && x.rows == y.rows,
              "x ({}, {}) · w ({}, {}) + b ({}) = y ({}, {})", x.rows, x.cols, w.rows, w.cols,
              b.cols, y.rows, y.cols);
  Multiply(Product<Scalar>{.m = x.rows,
                           .n = w.cols,
                           .k = x.cols,
                           .a = x.data,
                           .a_row_stride = x.cols,
                           .a_col_stride = 1,
                           .b = w.data,
                           .bias = b.data,
                           .rectify = activation == Activation::kRelu,
                           .c = y.data});
}

template <typename Scalar>
void LinearBackward(ConstMatrix<Scalar> x, ConstMatrix<Scalar> w, ConstMatrix<Scalar> dy,
                    const LinearGradient<Scalar>& gradient) {
  RONDA_CHECK(x.cols == w.rows && w.cols == dy.cols && x.rows == dy.rows,
              "x ({}, {}) · w ({}, {}), dy ({}, {})", x.rows, x.cols, w.rows, w.cols, dy.rows,
              dy.cols);
  // y = x·w + b   ⇒   ∂L/∂w = xᵀ·dy
  Multiply(Product<Scalar>{.m = x.cols,
                           .n = dy.cols,
                           .k = x.rows,
                           .a = x.data,
                           .a_row_stride = 1,
                           .a_col_stride = x.cols,
                           .b = dy.data,
                           .accumulate = true,
                           .c = gradient.w.data});
  // y = x·w + b   ⇒   ∂L/∂b = Σ over the rows of dy
  if constexpr (std::is_same_v<Scalar, float>)
    LoopsInUse().add_rows(dy.data, dy.rows, dy.cols, gradient.b.data);
  else
    AddRowsLoop(dy.data, dy.rows, dy.cols, gradient.b.data);
  if (gradient.x.data == nullptr) return;
  // y = x·w + b   ⇒   ∂L/∂x = dy·wᵀ
  Multiply(Product<Scalar>{.m = dy.rows,
                           .n = w.rows,
                           .k = dy.cols,
                           .a = dy.data,
                           .a_row_stride = dy.cols,
                           .a_col_stride = 1,
                           .b = w.data,
                           .b_transposed = true,
                           .c = gradient.x.data});
}

template void LinearForward(ConstMatrix<float>, ConstMatrix<float>, ConstMatrix<float>,
                            MatrixView<float>, Activation);
template void LinearForward(ConstMatrix<double>, ConstMatrix<double>, ConstMatrix<double>,
                            MatrixView<double>, Activation);
template void LinearBackward(ConstMatrix<float>, ConstMatrix<float>, ConstMatrix<float>,
                             const LinearGradient<float>&);
template void LinearBackward(ConstMatrix<double>, ConstMatrix<double>, ConstMatrix<double>,
                             const LinearGradient<double>&);

}  // namespace ronda
