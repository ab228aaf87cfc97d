#include "common/nn/losses.h"

#include <cmath>

namespace ronda {

template <typename Scalar>
LossValue<Scalar> Loss(LossKind kind, Scalar error, Scalar delta) {
  const Scalar two = 2;
  if (kind == LossKind::kSquared) return {error * error, two * error};
  const Scalar size = std::abs(error);
  if (size <= delta) return {error * error / two, error};
  return {delta * (size - delta / two), std::copysign(delta, error)};
}

template LossValue<float> Loss(LossKind, float, float);
template LossValue<double> Loss(LossKind, double, double);

}  // namespace ronda
