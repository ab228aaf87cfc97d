#pragma once
// The Double-DQN update of a perceptron written with Eigen's own expressions: the plain reference.
//
// Same arithmetic as learner/dqn.h with its defaults (Huber, norm clip, Adam, no target update).
// Compiled like the rest of the bench, without -m flags, so Eigen's products run on the baseline
// instruction set. Every action is taken to be legal and every discount not to be 0.
#include <Eigen/Core>
#include <span>
#include <vector>

#include "common/rl/messages.h"
#include "learner/dqn.h"

namespace ronda::bench {

class EigenDqn {
 public:
  /// `config.network` is a kMlp without LayerNorm; `parameters` as its flat vector.
  EigenDqn(const DqnConfig& config, std::span<const float> parameters);

  /// Returns the loss.
  double Update(const SampledBatch& batch);

 private:
  using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Input = Eigen::Map<const Matrix>;
  struct Layer {
    Matrix w;              // (I, O)
    Eigen::RowVectorXf b;  // (O)
  };

  /// The layers' outputs (B, O), the last one's being Q.
  void Forward(const std::vector<Layer>& layers, const Input& x, std::vector<Matrix>& outputs);
  void Backward(const Input& x, const Matrix& dq);
  void AdamStep();

  DqnConfig config_;
  std::vector<Layer> online_, target_, gradient_, m_, v_;
  std::vector<Matrix> outputs_, next_outputs_, target_outputs_;
  Matrix d_, dx_, dq_;
  int steps_ = 0;
};

}  // namespace ronda::bench
