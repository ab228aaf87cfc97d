#include "replay/sum_tree.h"

#include <bit>
#include <cmath>

#include "common/base/check.h"

namespace ronda {

SumTree::SumTree(std::size_t capacity)
    : leaf_begin_(std::bit_ceil(capacity)), nodes_(2 * leaf_begin_, 0.0) {}

void SumTree::Set(std::size_t index, double weight) {
  RONDA_CHECK(std::isfinite(weight) && weight >= 0.0, "weight {} at {}", weight, index);
  std::size_t node = leaf_begin_ + index;
  nodes_[node] = weight;
  while (node > 1) {
    node /= 2;
    nodes_[node] = nodes_[2 * node] + nodes_[2 * node + 1];
  }
}

std::size_t SumTree::Find(double position) const {
  RONDA_CHECK(total() > 0.0, "an empty tree was asked for position {}", position);
  std::size_t node = 1;
  while (node < leaf_begin_) {
    const double left = nodes_[2 * node];
    const bool go_left = position < left ? left > 0.0 : nodes_[2 * node + 1] <= 0.0;
    if (!go_left) position -= left;
    node = 2 * node + (go_left ? 0 : 1);
  }
  return node - leaf_begin_;
}

}  // namespace ronda
