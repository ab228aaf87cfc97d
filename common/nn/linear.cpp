#include "common/nn/linear.h"

#include "common/base/check.h"
#include "common/nn/gemm.h"

namespace ronda {

template <typename Scalar>
void LinearForward(ConstMatrix<Scalar> x, ConstMatrix<Scalar> w, ConstMatrix<Scalar> b,
                   MatrixView<Scalar> y) {
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
                           .c = y.data});
}

template <typename Scalar>
void LinearBackward(ConstMatrix<Scalar> x, ConstMatrix<Scalar> w, ConstMatrix<Scalar> dy,
                    const LinearGradient<Scalar>& gradient, std::vector<Scalar>& scratch) {
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
  for (int r = 0; r < dy.rows; ++r) {
    const Scalar* const from = dy.row(r);
    for (int c = 0; c < dy.cols; ++c) gradient.b.data[c] += from[c];
  }
  if (gradient.x.data == nullptr) return;
  // y = x·w + b   ⇒   ∂L/∂x = dy·wᵀ
  if (scratch.size() < w.size()) scratch.resize(w.size());
  const MatrixView<Scalar> transposed{scratch.data(), w.cols, w.rows};
  for (int i = 0; i < w.rows; ++i)
    for (int o = 0; o < w.cols; ++o) transposed.row(o)[i] = w.row(i)[o];
  Multiply(Product<Scalar>{.m = dy.rows,
                           .n = w.rows,
                           .k = dy.cols,
                           .a = dy.data,
                           .a_row_stride = dy.cols,
                           .a_col_stride = 1,
                           .b = transposed.data,
                           .c = gradient.x.data});
}

template void LinearForward(ConstMatrix<float>, ConstMatrix<float>, ConstMatrix<float>,
                            MatrixView<float>);
template void LinearForward(ConstMatrix<double>, ConstMatrix<double>, ConstMatrix<double>,
                            MatrixView<double>);
template void LinearBackward(ConstMatrix<float>, ConstMatrix<float>, ConstMatrix<float>,
                             const LinearGradient<float>&, std::vector<float>&);
template void LinearBackward(ConstMatrix<double>, ConstMatrix<double>, ConstMatrix<double>,
                             const LinearGradient<double>&, std::vector<double>&);

}  // namespace ronda
