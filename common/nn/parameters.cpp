#include "common/nn/parameters.h"

#include <utility>

#include "common/base/check.h"
#include "common/base/rng.h"

namespace ronda {

std::size_t ParameterLayout::Add(std::string name, int rows, int cols) {
  RONDA_CHECK(rows >= 1 && cols >= 1, "block {} is {} by {}", name, rows, cols);
  for (const ParameterBlock& block : blocks_)
    RONDA_CHECK(block.name != name, "block {} exists already", name);
  blocks_.push_back({.name = std::move(name), .rows = rows, .cols = cols, .offset = size_});
  size_ += blocks_.back().size();
  return blocks_.size() - 1;
}

std::uint64_t Hash64(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325ull;
  for (const char character : text) {
    hash ^= static_cast<unsigned char>(character);
    hash *= 0x100000001B3ull;
  }
  return Rng::NextSplitMix(hash);
}

}  // namespace ronda
