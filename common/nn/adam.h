#pragma once
// Adam with bias correction, over one flat vector; and clipping of the gradient's norm.
//
// m ← β1·m + (1 − β1)·g, v ← β2·v + (1 − β2)·g², θ ← θ − α·m̂ / (√v̂ + ε). The state can be saved and
// set. Sizes that disagree are a bug. Thread-compatible; O(parameters). Source: Kingma & Ba 2015,
// Alg. 1; Pascanu, Mikolov & Bengio 2013 (clipping).
#include <cstdint>
#include <span>
#include <vector>

namespace ronda {

struct AdamConfig {
  double beta1 = 0.9;
  double beta2 = 0.999;
  double epsilon = 1e-8;
};

template <typename Scalar>
struct AdamState {
  std::vector<Scalar> m;    // (P)
  std::vector<Scalar> v;    // (P)
  std::uint64_t steps = 0;  // taken so far
};

template <typename Scalar>
class Adam {
 public:
  explicit Adam(std::size_t parameter_count, const AdamConfig& config = {});

  void Step(std::span<const Scalar> gradient, double learning_rate, std::span<Scalar> parameters);

  const AdamState<Scalar>& state() const { return state_; }
  void set_state(AdamState<Scalar> state);  // of the same size

 private:
  AdamConfig config_;
  AdamState<Scalar> state_;
};

/// Scales the gradient so that its Euclidean norm is at most `max_norm`; returns the norm before.
/// A norm that is not finite leaves the gradient as it is.
template <typename Scalar>
double ClipGradientNorm(double max_norm, std::span<Scalar> gradient);

extern template class Adam<float>;
extern template class Adam<double>;

}  // namespace ronda
