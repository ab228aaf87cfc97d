#pragma once
// A row-major matrix that somebody else owns: a pointer and two sizes.
//
// Rows are packed (stride = cols). Copy it freely. Light on purpose: Eigen stays in the .cpp files.
#include <cstddef>
#include <type_traits>

namespace ronda {

template <typename Scalar>
struct MatrixView {
  Scalar* data = nullptr;
  int rows = 0;
  int cols = 0;

  Scalar* row(int r) const { return data + static_cast<std::ptrdiff_t>(r) * cols; }
  std::size_t size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  }
  operator MatrixView<const Scalar>() const requires(!std::is_const_v<Scalar>) {
    return {data, rows, cols};
  }
};

/// What a function reads. Not deduced, so that what it writes alone decides the scalar.
template <typename Scalar>
using ConstMatrix = std::type_identity_t<MatrixView<const Scalar>>;

}  // namespace ronda
