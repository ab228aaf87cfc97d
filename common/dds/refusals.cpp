#include "common/dds/refusals.h"

#include <fmt/format.h>

namespace ronda::dds {

void Refusals::Add(const std::string& topic, const std::string& sender, const std::string& reason) {
  constexpr std::size_t kMost = 1000;  // sentences remembered, whoever sends rubbish
  ++count_;
  std::string sentence = fmt::format("{}: a message of {} is refused: {}", topic, sender, reason);
  if (said_.size() < kMost && said_.insert(sentence).second) {
    sentences_.push_back(std::move(sentence));
  }
}

}  // namespace ronda::dds
