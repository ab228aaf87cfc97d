#pragma once
// Strings and vectors through cereal's portable binary archive, without trusting announced lengths.
//
// cereal allocates what a length says before it reads; a damaged or hostile length would allocate
// gigabytes. Here a length is compared with the bytes that are left first. For .cpp files only.
// Errors: BoundedInput throws std::runtime_error with what is wrong (cereal's own exceptions are
// such, too): callers add the file's name.
#include <cereal/archives/portable_binary.hpp>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace ronda {

class BoundedOutput {
 public:
  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void Put(Value value) { archive_(value); }
  void Put(const std::string& text) { PutAll(text.data(), text.size()); }
  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void Put(const std::vector<Value>& values) { PutAll(values.data(), values.size()); }
  std::string Bytes() const { return stream_.str(); }

 private:
  template <typename Value>
  void PutAll(const Value* values, std::size_t count) {
    Put(static_cast<std::uint64_t>(count));
    archive_(cereal::binary_data(values, count * sizeof(Value)));
  }

  std::ostringstream stream_;
  cereal::PortableBinaryOutputArchive archive_{stream_};
};

class BoundedInput {
 public:
  explicit BoundedInput(const std::string& bytes)
      : size_(bytes.size()), stream_(bytes), archive_(stream_) {}

  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void Get(Value& value) {
    if (sizeof(Value) > Left()) throw std::runtime_error("it ends too early");
    archive_(value);
  }
  void Get(std::string& text) { GetAll(text); }
  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void Get(std::vector<Value>& values) { GetAll(values); }
  /// A number of elements to come, each of which takes at least `least_size` (≥ 1) bytes.
  std::uint64_t GetCount(std::size_t least_size) {
    std::uint64_t count = 0;
    Get(count);
    if (count > Left() / least_size)
      throw std::runtime_error("a length exceeds what is left of it");
    return count;
  }
  std::size_t Left() { return size_ - static_cast<std::size_t>(stream_.tellg()); }

 private:
  template <typename Container>
  void GetAll(Container& values) {
    using Value = typename Container::value_type;
    values.resize(static_cast<std::size_t>(GetCount(sizeof(Value))));
    archive_(cereal::binary_data(values.data(), values.size() * sizeof(Value)));
  }

  std::size_t size_;
  std::istringstream stream_;
  cereal::PortableBinaryInputArchive archive_;
};

}  // namespace ronda
