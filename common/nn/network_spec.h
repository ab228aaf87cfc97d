#pragma once
// What a Q network looks like, and the 64-bit name of its architecture.
//
// kMlp: one perceptron from the observation (O) to A values. kCandidateScorer: the observation is A
// rows of `features` numbers, one row for each candidate action, and one perceptron with a single
// output scores each row; so the weights, and the hash, depend on neither A nor O and one network
// serves every map and team size. Weights load only where hashes agree.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/nn/mlp.h"

namespace ronda {

struct NetworkSpec {
  enum class Kind { kMlp, kCandidateScorer };
  Kind kind = Kind::kMlp;
  int observation_size = 0;      // O
  int num_actions = 0;           // A
  int features = 0;              // F, scorer only: O = A·F
  std::vector<int> hidden = {};  // widths
  bool layer_norm = false;
  std::string schema = {};  // name of the observation that it reads: letters, digits, '-', '_', '.'
  friend bool operator==(const NetworkSpec&, const NetworkSpec&) = default;
};

/// Throws InputError naming the rule and the value; afterwards the sizes are safe to allocate (at
/// most 2^26 parameters).
void CheckNetworkSpec(const NetworkSpec& spec);

/// The canonical text that the hash is made of, e.g.
/// "scorer schema=patrol26 features=26 hidden=64,64 layer_norm=0 activation=relu format=1".
std::string DescribeArchitecture(const NetworkSpec& spec);
std::uint64_t ArchitectureHash(const NetworkSpec& spec);

/// The perceptron inside.
MlpSpec PerceptronOf(const NetworkSpec& spec);

/// Length of the flat weight vector, computed without allocating it. The spec has been checked.
std::size_t ParameterCount(const NetworkSpec& spec);

}  // namespace ronda
