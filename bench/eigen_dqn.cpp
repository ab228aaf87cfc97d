#include "bench/eigen_dqn.h"

#include <cmath>

#include "common/nn/losses.h"

namespace ronda::bench {

EigenDqn::EigenDqn(const DqnConfig& config, std::span<const float> parameters) : config_(config) {
  const float* from = parameters.data();
  int inputs = config.network.observation_size;
  std::vector<int> widths = config.network.hidden;
  widths.push_back(config.network.num_actions);
  for (const int width : widths) {
    Layer layer{.w = Input(from, inputs, width), .b = {}};
    from += layer.w.size();
    layer.b = Eigen::Map<const Eigen::RowVectorXf>(from, width);
    from += width;
    online_.push_back(layer);
    inputs = width;
  }
  target_ = gradient_ = m_ = v_ = online_;
  for (auto* const moments : {&m_, &v_}) {
    for (Layer& layer : *moments) {
      layer.w.setZero();
      layer.b.setZero();
    }
  }
}

void EigenDqn::Forward(const std::vector<Layer>& layers, const Input& x,
                       std::vector<Matrix>& outputs) {
  outputs.resize(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i == 0)
      outputs[i].noalias() = x * layers[i].w;
    else
      outputs[i].noalias() = outputs[i - 1] * layers[i].w;
    outputs[i].rowwise() += layers[i].b;
    if (i + 1 < layers.size()) outputs[i] = outputs[i].cwiseMax(0.0f);
  }
}

void EigenDqn::Backward(const Input& x, const Matrix& dq) {
  d_ = dq;
  for (std::size_t i = online_.size(); i-- > 0;) {
    if (i == 0)
      gradient_[i].w.noalias() = x.transpose() * d_;
    else
      gradient_[i].w.noalias() = outputs_[i - 1].transpose() * d_;
    gradient_[i].b = d_.colwise().sum();
    if (i == 0) return;
    dx_.noalias() = d_ * online_[i].w.transpose();
    d_ = (outputs_[i - 1].array() > 0.0f).select(dx_, 0.0f);
  }
}

void EigenDqn::AdamStep() {
  double squares = 0.0;
  for (const Layer& g : gradient_)
    squares += g.w.cast<double>().squaredNorm() + g.b.cast<double>().squaredNorm();
  const double norm = std::sqrt(squares);
  const auto clip =
      static_cast<float>(norm > config_.max_gradient_norm ? config_.max_gradient_norm / norm : 1.0);
  ++steps_;
  const AdamConfig& adam = config_.adam;
  const auto beta1 = static_cast<float>(adam.beta1), beta2 = static_cast<float>(adam.beta2);
  const auto step =
      static_cast<float>(config_.learning_rate_start / (1.0 - std::pow(adam.beta1, steps_)));
  const auto spread = static_cast<float>(1.0 / std::sqrt(1.0 - std::pow(adam.beta2, steps_)));
  const auto epsilon = static_cast<float>(adam.epsilon);
  const auto follow = [&](auto& g, auto& m, auto& v, auto& theta) {
    if (clip < 1.0f) g *= clip;
    m = beta1 * m + (1.0f - beta1) * g;
    v = beta2 * v + (1.0f - beta2) * g.cwiseAbs2();
    theta.array() -= step * m.array() / (v.array().sqrt() * spread + epsilon);
  };
  for (std::size_t i = 0; i < online_.size(); ++i) {
    follow(gradient_[i].w, m_[i].w, v_[i].w, online_[i].w);
    follow(gradient_[i].b, m_[i].b, v_[i].b, online_[i].b);
  }
}

double EigenDqn::Update(const SampledBatch& batch) {
  const int count = static_cast<int>(batch.count);
  const Input s(batch.observations.data(), count, config_.network.observation_size);
  const Input next_s(batch.next_observations.data(), count, config_.network.observation_size);
  Forward(online_, next_s, next_outputs_);
  Forward(target_, next_s, target_outputs_);
  Forward(online_, s, outputs_);
  dq_.setZero(count, config_.network.num_actions);
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    Eigen::Index best = 0;
    next_outputs_.back().row(i).maxCoeff(&best);
    const float y = batch.rewards[i] + batch.discounts[i] * target_outputs_.back()(i, best);
    const float error = outputs_.back()(i, batch.actions[i]) - y;
    const auto loss = Loss(config_.loss.loss, error, static_cast<float>(config_.loss.huber_delta));
    const float weight = batch.importance_weights[i] / static_cast<float>(count);
    dq_(i, batch.actions[i]) = weight * loss.slope;
    sum += static_cast<double>(weight * loss.value);
  }
  Backward(s, dq_);
  AdamStep();
  return sum;
}

}  // namespace ronda::bench
