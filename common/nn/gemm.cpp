#include "common/nn/gemm.h"

#include <Eigen/Core>

#include "common/nn/gemm_kernels.h"

namespace ronda {
namespace {

template <typename Scalar>
using RowMajor = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <typename Scalar>
void MultiplyEigen(const Product<Scalar>& p) {
  const Eigen::Map<const RowMajor<Scalar>> b(p.b, p.k, p.n);
  Eigen::Map<RowMajor<Scalar>> c(p.c, p.m, p.n);
  if (p.bias != nullptr)
    c.rowwise() = Eigen::Map<const Eigen::Matrix<Scalar, 1, Eigen::Dynamic>>(p.bias, p.n);
  else if (!p.accumulate)
    c.setZero();
  if (p.a_col_stride == 1) {
    const Eigen::Map<const RowMajor<Scalar>, 0, Eigen::OuterStride<>> a(
        p.a, p.m, p.k, Eigen::OuterStride<>(p.a_row_stride));
    c.noalias() += a * b;
  } else {
    const Eigen::Map<const RowMajor<Scalar>, 0, Eigen::OuterStride<>> a_transposed(
        p.a, p.k, p.m, Eigen::OuterStride<>(p.a_col_stride));
    c.noalias() += a_transposed.transpose() * b;
  }
}

GemmKernel DetectBestKernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return GemmKernel::kTileAvx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return GemmKernel::kTileAvx2;
#endif
  return GemmKernel::kTileBaseline;
}

}  // namespace

GemmKernel BestGemmKernel() {
  static const GemmKernel kBest = DetectBestKernel();
  return kBest;
}

void Multiply(const Product<double>& product) { MultiplyEigen(product); }

void Multiply(const Product<float>& product) {
  switch (BestGemmKernel()) {
#if defined(__x86_64__)
    case GemmKernel::kTileAvx512:
      return internal::MultiplyTileAvx512(product);
    case GemmKernel::kTileAvx2:
      return internal::MultiplyTileAvx2(product);
#endif
    case GemmKernel::kTileBaseline:
      return internal::MultiplyTileBaseline(product);
    default:
      return MultiplyEigen(product);
  }
}

bool MultiplyWith(GemmKernel kernel, const Product<float>& product) {
  switch (kernel) {
    case GemmKernel::kEigen:
      MultiplyEigen(product);
      return true;
    case GemmKernel::kTileBaseline:
      internal::MultiplyTileBaseline(product);
      return true;
#if defined(__x86_64__)
    case GemmKernel::kTileAvx2:
      if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return false;
      internal::MultiplyTileAvx2(product);
      return true;
    case GemmKernel::kTileAvx512:
      if (!__builtin_cpu_supports("avx512f")) return false;
      internal::MultiplyTileAvx512(product);
      return true;
#endif
    default:
      return false;
  }
}

}  // namespace ronda
