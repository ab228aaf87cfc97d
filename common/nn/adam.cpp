#include "common/nn/adam.h"

#include <array>
#include <cmath>
#include <utility>

#include "common/base/check.h"

namespace ronda {

template <typename Scalar>
Adam<Scalar>::Adam(std::size_t parameter_count, const AdamConfig& config) : config_(config) {
  state_.m.assign(parameter_count, Scalar(0));
  state_.v.assign(parameter_count, Scalar(0));
}

template <typename Scalar>
void Adam<Scalar>::set_state(AdamState<Scalar> state) {
  RONDA_CHECK(state.m.size() == state_.m.size() && state.v.size() == state_.v.size(),
              "{} and {} moments for {} parameters", state.m.size(), state.v.size(),
              state_.m.size());
  state_ = std::move(state);
}

template <typename Scalar>
void Adam<Scalar>::Step(std::span<const Scalar> gradient, double learning_rate,
                        std::span<Scalar> parameters) {
  const std::size_t count = state_.m.size();
  RONDA_CHECK(gradient.size() == count && parameters.size() == count,
              "{} gradients and {} parameters for {} moments", gradient.size(), parameters.size(),
              count);
  const double steps = static_cast<double>(++state_.steps);
  // α·m̂ / (√v̂ + ε) = step·m / (√v·spread + ε) with the bias corrections in `step` and `spread`
  const auto step = static_cast<Scalar>(learning_rate / (1.0 - std::pow(config_.beta1, steps)));
  const auto spread = static_cast<Scalar>(1.0 / std::sqrt(1.0 - std::pow(config_.beta2, steps)));
  const auto epsilon = static_cast<Scalar>(config_.epsilon);
  const auto keep1 = static_cast<Scalar>(config_.beta1);
  const auto keep2 = static_cast<Scalar>(config_.beta2);
  const auto take1 = static_cast<Scalar>(1.0 - config_.beta1);
  const auto take2 = static_cast<Scalar>(1.0 - config_.beta2);
  const Scalar* const g = gradient.data();
  Scalar* const m = state_.m.data();
  Scalar* const v = state_.v.data();
  Scalar* const theta = parameters.data();
  for (std::size_t i = 0; i < count; ++i) {
    m[i] = keep1 * m[i] + take1 * g[i];
    v[i] = keep2 * v[i] + take2 * g[i] * g[i];
    theta[i] -= step * m[i] / (std::sqrt(v[i]) * spread + epsilon);
  }
}

template <typename Scalar>
double ClipGradientNorm(double max_norm, std::span<Scalar> gradient) {
  std::array<double, 8> lanes{};  // partial sums side by side, always in the same order
  const std::size_t whole = gradient.size() / lanes.size() * lanes.size();
  for (std::size_t i = 0; i < whole; i += lanes.size()) {
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      const auto value = static_cast<double>(gradient[i + lane]);
      lanes[lane] += value * value;
    }
  }
  double sum = 0.0;
  for (const double lane : lanes) sum += lane;
  for (std::size_t i = whole; i < gradient.size(); ++i)
    sum += static_cast<double>(gradient[i]) * static_cast<double>(gradient[i]);
  const double norm = std::sqrt(sum);
  if (std::isfinite(norm) && norm > max_norm) {
    const auto scale = static_cast<Scalar>(max_norm / norm);
    for (Scalar& value : gradient) value *= scale;
  }
  return norm;
}

template class Adam<float>;
template class Adam<double>;
template double ClipGradientNorm(double, std::span<float>);
template double ClipGradientNorm(double, std::span<double>);

}  // namespace ronda
