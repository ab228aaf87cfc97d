#pragma once
// Where each weight lies in the one flat vector that holds them all.
//
// A network adds its blocks in order; the optimiser, a checkpoint and a broadcast then see one
// array. Hash64 names an architecture by its canonical description: FNV-1a (Fowler, Noll & Vo),
// finished with splitmix64 so that similar descriptions differ in every bit. The values are the
// same on every machine.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ronda {

struct ParameterBlock {
  std::string name;
  int rows = 0;
  int cols = 0;
  std::size_t offset = 0;  // of its first value; row-major from there
  std::size_t size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  }
};

class ParameterLayout {
 public:
  /// Appends a block (rows, cols ≥ 1; the name is new: else a bug) and returns its index.
  std::size_t Add(std::string name, int rows, int cols);

  const std::vector<ParameterBlock>& blocks() const { return blocks_; }
  std::size_t size() const { return size_; }  // of the flat vector

 private:
  std::vector<ParameterBlock> blocks_;
  std::size_t size_ = 0;
};

std::uint64_t Hash64(std::string_view text);

}  // namespace ronda
