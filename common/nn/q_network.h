#pragma once
// Action values Q(s, a) of a NetworkSpec, for batches and for a single observation alike.
//
// Holds no weights: they come as one flat vector (P). Observations (B, O) and legal actions (B, A)
// are row-major; sizes that disagree are a bug. A scorer gathers the rows of the candidates that
// matter and runs its perceptron on them alone, so illegal actions cost nothing. Thread-safe:
// workspaces belong to the caller and allocate nothing once they have grown. Float and double.
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/base/rng.h"
#include "common/nn/mlp.h"
#include "common/nn/network_spec.h"

namespace ronda {

template <typename Scalar>
class QNetwork {
 public:
  static constexpr Scalar kIllegal = -std::numeric_limits<Scalar>::infinity();
  static constexpr std::int32_t kNoAction = -1;

  class Workspace {
   private:
    friend class QNetwork;
    typename Mlp<Scalar>::Workspace mlp_;
    std::vector<Scalar> input_;   // (rows, F) candidates gathered by a scorer
    std::vector<Scalar> output_;  // (rows, O of the perceptron) gradients to send back
    MatrixView<const Scalar> x_;  // what the perceptron read last
  };

  explicit QNetwork(NetworkSpec spec);  // InputError as CheckNetworkSpec

  const NetworkSpec& spec() const { return spec_; }
  const ParameterLayout& layout() const { return mlp_.layout(); }
  std::size_t parameter_count() const { return mlp_.layout().size(); }
  std::uint64_t architecture_hash() const { return architecture_hash_; }

  void Initialise(Rng& rng, std::span<Scalar> parameters) const {
    mlp_.Initialise(rng, parameters);
  }

  /// q (B, A): Q where legal is not 0, else kIllegal. B may be 0 and a row may have no legal
  /// action.
  void Forward(std::span<const Scalar> parameters, std::span<const Scalar> observations,
               std::span<const std::uint8_t> legal, Workspace& workspace,
               std::span<Scalar> q) const;

  /// q (B): Q of one action (B) of each row; 0 for kNoAction. The observations must live until
  /// BackwardChosen.
  void ForwardChosen(std::span<const Scalar> parameters, std::span<const Scalar> observations,
                     std::span<const std::int32_t> actions, Workspace& workspace,
                     std::span<Scalar> q) const;

  /// Adds ∂L/∂parameters to `gradient`, from dq = ∂L/∂q (B). Follows ForwardChosen with the same
  /// parameters, actions and workspace.
  void BackwardChosen(std::span<const Scalar> parameters, std::span<const std::int32_t> actions,
                      std::span<const Scalar> dq, Workspace& workspace,
                      std::span<Scalar> gradient) const;

 private:
  bool scorer() const { return spec_.kind == NetworkSpec::Kind::kCandidateScorer; }

  NetworkSpec spec_;
  std::uint64_t architecture_hash_;
  Mlp<Scalar> mlp_;
};

extern template class QNetwork<float>;
extern template class QNetwork<double>;

}  // namespace ronda
