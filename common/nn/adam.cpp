#include "common/nn/adam.h"

#include <cmath>
#include <type_traits>
#include <utility>

#include "common/base/check.h"
#include "common/nn/loops.h"

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
  const AdamStep<Scalar> step{
      .size = count,
      .keep1 = static_cast<Scalar>(config_.beta1),
      .keep2 = static_cast<Scalar>(config_.beta2),
      .take1 = static_cast<Scalar>(1.0 - config_.beta1),
      .take2 = static_cast<Scalar>(1.0 - config_.beta2),
      .step = static_cast<Scalar>(learning_rate / (1.0 - std::pow(config_.beta1, steps))),
      .spread = static_cast<Scalar>(1.0 / std::sqrt(1.0 - std::pow(config_.beta2, steps))),
      .epsilon = static_cast<Scalar>(config_.epsilon),
      .gradient = gradient.data(),
      .m = state_.m.data(),
      .v = state_.v.data(),
      .parameters = parameters.data()};
  if constexpr (std::is_same_v<Scalar, float>)
    LoopsInUse().adam_step(step);
  else
    AdamStepLoop(step);
}

template <typename Scalar>
double ClipGradientNorm(double max_norm, std::span<Scalar> gradient) {
  constexpr bool kFloat = std::is_same_v<Scalar, float>;
  double sum = 0.0;
  if constexpr (kFloat)
    sum = LoopsInUse().sum_of_squares(gradient.data(), gradient.size());
  else
    sum = SumOfSquaresLoop(gradient.data(), gradient.size());
  const double norm = std::sqrt(sum);
  if (std::isfinite(norm) && norm > max_norm) {
    const auto scale = static_cast<Scalar>(max_norm / norm);
    if constexpr (kFloat)
      LoopsInUse().scale(gradient.data(), gradient.size(), scale);
    else
      ScaleLoop(gradient.data(), gradient.size(), scale);
  }
  return norm;
}

template class Adam<float>;
template class Adam<double>;
template double ClipGradientNorm(double, std::span<float>);
template double ClipGradientNorm(double, std::span<double>);

}  // namespace ronda
