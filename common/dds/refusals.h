#pragma once
// Messages that were refused: counted all, put into words once for each sender and reason.
// Thread-compatible.
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ronda::dds {

class Refusals {
 public:
  void Add(const std::string& topic, const std::string& sender, const std::string& reason);
  std::uint64_t count() const { return count_; }
  /// The sentences since the last call.
  std::vector<std::string> Take() { return std::exchange(sentences_, {}); }

 private:
  std::uint64_t count_ = 0;
  std::set<std::string> said_;
  std::vector<std::string> sentences_;
};

}  // namespace ronda::dds
