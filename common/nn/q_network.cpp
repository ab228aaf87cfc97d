#include "common/nn/q_network.h"

#include <algorithm>
#include <utility>

#include "common/base/check.h"

namespace ronda {
namespace {

const NetworkSpec& Checked(const NetworkSpec& spec) {
  CheckNetworkSpec(spec);
  return spec;
}

}  // namespace

template <typename Scalar>
QNetwork<Scalar>::QNetwork(NetworkSpec spec)
    : spec_(std::move(spec)),
      architecture_hash_(ArchitectureHash(Checked(spec_))),
      mlp_(PerceptronOf(spec_)) {}

template <typename Scalar>
void QNetwork<Scalar>::Forward(std::span<const Scalar> parameters,
                               std::span<const Scalar> observations,
                               std::span<const std::uint8_t> legal, Workspace& workspace,
                               std::span<Scalar> q) const {
  const auto num_actions = static_cast<std::size_t>(spec_.num_actions);
  const std::size_t batch = q.size() / num_actions;
  RONDA_CHECK(q.size() == batch * num_actions && legal.size() == q.size() &&
                  observations.size() == batch * static_cast<std::size_t>(spec_.observation_size),
              "{} observations, {} legal, {} q", observations.size(), legal.size(), q.size());
  if (!scorer()) {
    workspace.x_ = {observations.data(), static_cast<int>(batch), spec_.observation_size};
    const auto y = mlp_.Forward(parameters, workspace.x_, workspace.mlp_);  // (B, A)
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = legal[i] != 0 ? y.data[i] : kIllegal;
    return;
  }
  const auto features = static_cast<std::size_t>(spec_.features);
  if (workspace.input_.size() < observations.size()) workspace.input_.resize(observations.size());
  Scalar* to = workspace.input_.data();
  int rows = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (legal[i] == 0) continue;
    to = std::copy_n(observations.data() + i * features, features, to);
    ++rows;
  }
  workspace.x_ = {workspace.input_.data(), rows, spec_.features};
  const Scalar* y = mlp_.Forward(parameters, workspace.x_, workspace.mlp_).data;  // (rows, 1)
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = legal[i] != 0 ? *y++ : kIllegal;
}

template <typename Scalar>
void QNetwork<Scalar>::ForwardChosen(std::span<const Scalar> parameters,
                                     std::span<const Scalar> observations,
                                     std::span<const std::int32_t> actions, Workspace& workspace,
                                     std::span<Scalar> q) const {
  const std::size_t batch = actions.size();
  const auto observation_size = static_cast<std::size_t>(spec_.observation_size);
  RONDA_CHECK(q.size() == batch && observations.size() == batch * observation_size,
              "{} observations, {} actions, {} q", observations.size(), batch, q.size());
  for (const std::int32_t action : actions)
    RONDA_CHECK(action >= kNoAction && action < spec_.num_actions, "action {} of {}", action,
                spec_.num_actions);
  if (!scorer()) {
    workspace.x_ = {observations.data(), static_cast<int>(batch), spec_.observation_size};
    const auto y = mlp_.Forward(parameters, workspace.x_, workspace.mlp_);  // (B, A)
    for (std::size_t i = 0; i < batch; ++i)
      q[i] = actions[i] == kNoAction ? Scalar(0) : y.row(static_cast<int>(i))[actions[i]];
    return;
  }
  const auto features = static_cast<std::size_t>(spec_.features);
  if (workspace.input_.size() < batch * features) workspace.input_.resize(batch * features);
  Scalar* to = workspace.input_.data();
  int rows = 0;
  for (std::size_t i = 0; i < batch; ++i) {
    if (actions[i] == kNoAction) continue;
    const auto action = static_cast<std::size_t>(actions[i]);
    to = std::copy_n(observations.data() + i * observation_size + action * features, features, to);
    ++rows;
  }
  workspace.x_ = {workspace.input_.data(), rows, spec_.features};
  const Scalar* y = mlp_.Forward(parameters, workspace.x_, workspace.mlp_).data;  // (rows, 1)
  for (std::size_t i = 0; i < batch; ++i) q[i] = actions[i] == kNoAction ? Scalar(0) : *y++;
}

template <typename Scalar>
void QNetwork<Scalar>::BackwardChosen(std::span<const Scalar> parameters,
                                      std::span<const std::int32_t> actions,
                                      std::span<const Scalar> dq, Workspace& workspace,
                                      std::span<Scalar> gradient) const {
  RONDA_CHECK(dq.size() == actions.size(), "{} slopes, {} actions", dq.size(), actions.size());
  const int outputs = scorer() ? 1 : spec_.num_actions;
  const std::size_t size = actions.size() * static_cast<std::size_t>(outputs);
  if (workspace.output_.size() < size) workspace.output_.resize(size);
  const MatrixView<Scalar> dy{workspace.output_.data(), workspace.x_.rows, outputs};
  // q[i] = y[i, actions[i]]   ⇒   ∂L/∂y[i, a] = dq[i] where a = actions[i], else 0
  std::fill_n(dy.data, dy.size(), Scalar(0));
  int row = 0;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (actions[i] != kNoAction) dy.row(row)[scorer() ? 0 : actions[i]] = dq[i];
    if (actions[i] != kNoAction || !scorer()) ++row;
  }
  RONDA_CHECK(row == dy.rows, "{} rows forward, {} back", dy.rows, row);
  mlp_.Backward(parameters, workspace.x_, dy, workspace.mlp_, gradient);
}

template class QNetwork<float>;
template class QNetwork<double>;

}  // namespace ronda
