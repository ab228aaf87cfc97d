#pragma once
// What the launcher said last. Thread-compatible. The participant must outlive it.
#include <memory>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class ControlReader {
 public:
  explicit ControlReader(Participant& participant);
  ~ControlReader();
  /// The newest word, once; nullptr if nothing new has come. Valid until the next call.
  const RunControl* Newest();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
