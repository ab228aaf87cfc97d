#pragma once
// A multilayer perceptron: Linear → [LayerNorm] → ReLU for each hidden layer, then Linear.
//
// Holds no weights: they come as one flat vector, laid out as `layout` says. B is the number of
// rows of a call, any ≥ 0. Weights: He normal (He et al. 2015), √(2/inputs); the last layer
// 0.1·√(1/inputs), so that first values are small. Thread-safe: what a call writes lies in the
// workspace of the caller, which grows to the largest batch seen and then allocates nothing.
// Backward follows a Forward with the same parameters, input and workspace. Float and double.
#include <span>
#include <vector>

#include "common/base/rng.h"
#include "common/nn/matrix.h"
#include "common/nn/parameters.h"

namespace ronda {

struct MlpSpec {
  int inputs = 1;           // I
  std::vector<int> hidden;  // widths
  int outputs = 1;          // O
  bool layer_norm = false;
};

template <typename Scalar>
class Mlp {
 public:
  class Workspace {
   private:
    friend class Mlp;
    struct Layer {
      std::vector<Scalar> normalised;         // (B, C) with LayerNorm only
      std::vector<Scalar> inverse_deviation;  // (B) with LayerNorm only
      std::vector<Scalar> output;             // (B, C)
    };
    std::vector<Layer> layers_;                     // hidden ones, then the last
    std::vector<Scalar> gradient_, next_gradient_;  // (B, widest layer)
  };

  explicit Mlp(const MlpSpec& spec);  // sizes ≥ 1, else a bug

  const ParameterLayout& layout() const { return layout_; }
  void Initialise(Rng& rng, std::span<Scalar> parameters) const;

  /// x (B, I) → y (B, O), which lies in the workspace until its next use.
  MatrixView<const Scalar> Forward(std::span<const Scalar> parameters, ConstMatrix<Scalar> x,
                                   Workspace& workspace) const;
  /// Adds ∂L/∂parameters to `gradient`, from dy = ∂L/∂y (B, O).
  void Backward(std::span<const Scalar> parameters, ConstMatrix<Scalar> x, ConstMatrix<Scalar> dy,
                Workspace& workspace, std::span<Scalar> gradient) const;

 private:
  struct Layer {
    std::size_t weights, bias, gain, shift;  // blocks of the layout; the last two with LayerNorm
    int inputs, outputs;
    bool hidden, layer_norm;
  };
  template <typename T>
  MatrixView<T> Block(std::span<T> parameters, std::size_t block) const;

  ParameterLayout layout_;
  std::vector<Layer> layers_;
  int widest_ = 1;
};

extern template class Mlp<float>;
extern template class Mlp<double>;

}  // namespace ronda
