#pragma once
// Non-negative weights under fast prefix sums: the structure behind proportional sampling (Schaul
// et al. 2016, §B.2.1).
//
// A complete binary tree over the next power of two ≥ capacity, in double; a node is always
// recomputed as the sum of its two children, so rounding does not drift over updates. Set and Find
// are O(log capacity). Thread-compatible.
#include <cstddef>
#include <vector>

namespace ronda {

class SumTree {
 public:
  explicit SumTree(std::size_t capacity);

  void Set(std::size_t index, double weight);  // finite and ≥ 0, else a bug
  double weight(std::size_t index) const { return nodes_[leaf_begin_ + index]; }
  double total() const { return nodes_[1]; }
  /// The index i with Σ_{j<i} w_j ≤ position < Σ_{j≤i} w_j, never one of weight 0; total() must be
  /// > 0.
  std::size_t Find(double position) const;

 private:
  std::size_t leaf_begin_;
  std::vector<double> nodes_;  // 1 is the root, children of k are 2k and 2k + 1
};

}  // namespace ronda
