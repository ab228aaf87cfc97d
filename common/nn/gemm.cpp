#include "common/nn/gemm.h"

#include <Eigen/Core>

#include "common/nn/loops.h"

namespace ronda {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstMap = Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>>;

/// c += a · b, where b lies as it is or transposed.
template <typename Left>
void AddProduct(const Left& a, const Product<double>& p, Eigen::Map<RowMajor>& c) {
  if (p.b_transposed)
    c.noalias() += a * ConstMap(p.b, p.n, p.k, Eigen::OuterStride<>(p.k)).transpose();
  else
    c.noalias() += a * ConstMap(p.b, p.k, p.n, Eigen::OuterStride<>(p.n));
}

}  // namespace

void Multiply(const Product<double>& p) {
  Eigen::Map<RowMajor> c(p.c, p.m, p.n);
  if (p.bias != nullptr)
    c.rowwise() = Eigen::Map<const Eigen::Matrix<double, 1, Eigen::Dynamic>>(p.bias, p.n);
  else if (!p.accumulate)
    c.setZero();
  if (p.a_col_stride == 1)
    AddProduct(ConstMap(p.a, p.m, p.k, Eigen::OuterStride<>(p.a_row_stride)), p, c);
  else
    AddProduct(ConstMap(p.a, p.k, p.m, Eigen::OuterStride<>(p.a_col_stride)).transpose(), p, c);
  if (p.rectify) c = (c.array() < 0.0).select(0.0, c);
}

void Multiply(const Product<float>& product) { LoopsInUse().multiply(product); }

}  // namespace ronda
