#include "common/nn/mlp.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "common/base/check.h"
#include "common/nn/activation.h"
#include "common/nn/layer_norm.h"
#include "common/nn/linear.h"

namespace ronda {
namespace {

constexpr double kLastLayerScale = 0.1;

/// A (rows, cols) view of a buffer that grows and never shrinks.
template <typename Scalar>
MatrixView<Scalar> Grow(std::vector<Scalar>& buffer, int rows, int cols) {
  const MatrixView<Scalar> view{nullptr, rows, cols};
  if (buffer.size() < view.size()) buffer.resize(view.size());
  return {buffer.data(), rows, cols};
}

}  // namespace

template <typename Scalar>
Mlp<Scalar>::Mlp(const MlpSpec& spec) {
  int inputs = spec.inputs;
  for (std::size_t i = 0; i <= spec.hidden.size(); ++i) {
    const bool hidden = i < spec.hidden.size();
    const int outputs = hidden ? spec.hidden[i] : spec.outputs;
    const std::string number = std::to_string(i);
    Layer layer{.weights = layout_.Add("w" + number, inputs, outputs),
                .bias = layout_.Add("b" + number, 1, outputs),
                .gain = 0,
                .shift = 0,
                .inputs = inputs,
                .outputs = outputs,
                .hidden = hidden,
                .layer_norm = hidden && spec.layer_norm};
    if (layer.layer_norm) {
      layer.gain = layout_.Add("gain" + number, 1, outputs);
      layer.shift = layout_.Add("shift" + number, 1, outputs);
    }
    layers_.push_back(layer);
    widest_ = std::max(widest_, outputs);
    inputs = outputs;
  }
}

template <typename Scalar>
template <typename T>
MatrixView<T> Mlp<Scalar>::Block(std::span<T> parameters, std::size_t block) const {
  const ParameterBlock& place = layout_.blocks()[block];
  return {parameters.data() + place.offset, place.rows, place.cols};
}

template <typename Scalar>
void Mlp<Scalar>::Initialise(Rng& rng, std::span<Scalar> parameters) const {
  RONDA_CHECK(parameters.size() == layout_.size(), "{} of {} parameters", parameters.size(),
              layout_.size());
  std::fill(parameters.begin(), parameters.end(), Scalar(0));
  for (const Layer& layer : layers_) {
    const double deviation = layer.hidden ? std::sqrt(2.0 / layer.inputs)
                                          : kLastLayerScale * std::sqrt(1.0 / layer.inputs);
    const MatrixView<Scalar> weights = Block(parameters, layer.weights);
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights.data[i] = static_cast<Scalar>(deviation * rng.Normal());
    if (!layer.layer_norm) continue;
    const MatrixView<Scalar> gain = Block(parameters, layer.gain);
    std::fill_n(gain.data, gain.size(), Scalar(1));
  }
}

template <typename Scalar>
MatrixView<const Scalar> Mlp<Scalar>::Forward(std::span<const Scalar> parameters,
                                              ConstMatrix<Scalar> x, Workspace& workspace) const {
  RONDA_CHECK(parameters.size() == layout_.size(), "{} of {} parameters", parameters.size(),
              layout_.size());
  workspace.layers_.resize(layers_.size());
  MatrixView<const Scalar> input = x;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const Layer& layer = layers_[i];
    auto& memory = workspace.layers_[i];
    const MatrixView<Scalar> output = Grow(memory.output, x.rows, layer.outputs);
    const auto weights = Block(parameters, layer.weights);
    const auto bias = Block(parameters, layer.bias);
    if (layer.layer_norm) {
      const MatrixView<Scalar> linear = Grow(memory.normalised, x.rows, layer.outputs);
      LinearForward(input, weights, bias, linear);
      LayerNormForward(Block(parameters, layer.gain), Block(parameters, layer.shift), linear,
                       Grow(memory.inverse_deviation, x.rows, 1), output);
      ReluForward(output);
    } else {
      LinearForward(input, weights, bias, output,
                    layer.hidden ? Activation::kRelu : Activation::kNone);
    }
    input = output;
  }
  return input;
}

template <typename Scalar>
void Mlp<Scalar>::Backward(std::span<const Scalar> parameters, ConstMatrix<Scalar> x,
                           ConstMatrix<Scalar> dy, Workspace& workspace,
                           std::span<Scalar> gradient) const {
  RONDA_CHECK(gradient.size() == layout_.size() && workspace.layers_.size() == layers_.size(),
              "{} of {} gradients", gradient.size(), layout_.size());
  Grow(workspace.gradient_, x.rows, widest_);
  Grow(workspace.next_gradient_, x.rows, widest_);
  MatrixView<const Scalar> d = dy;
  for (std::size_t i = layers_.size(); i-- > 0;) {
    const Layer& layer = layers_[i];
    auto& memory = workspace.layers_[i];
    if (layer.hidden) {
      const MatrixView<Scalar> own{workspace.gradient_.data(), x.rows, layer.outputs};
      ReluBackward({memory.output.data(), x.rows, layer.outputs}, own);
      if (layer.layer_norm)
        LayerNormBackward(
            {Block(parameters, layer.gain)}, {memory.normalised.data(), x.rows, layer.outputs},
            {memory.inverse_deviation.data(), x.rows, 1}, own,
            {.gain = Block(gradient, layer.gain), .shift = Block(gradient, layer.shift)});
    }
    const MatrixView<const Scalar> input =
        i == 0 ? x
               : MatrixView<const Scalar>{workspace.layers_[i - 1].output.data(), x.rows,
                                          layer.inputs};
    MatrixView<Scalar> dx{nullptr, x.rows, layer.inputs};
    if (i > 0) dx.data = workspace.next_gradient_.data();
    LinearBackward<Scalar>(
        input, Block(parameters, layer.weights), d,
        {.w = Block(gradient, layer.weights), .b = Block(gradient, layer.bias), .x = dx});
    std::swap(workspace.gradient_, workspace.next_gradient_);
    d = {workspace.gradient_.data(), x.rows, layer.inputs};
  }
}

template class Mlp<float>;
template class Mlp<double>;

}  // namespace ronda
