#pragma once
// The launcher's word to all processes; the newest counts, and late joiners get it.
// Thread-compatible. The participant must outlive it.
#include <memory>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class ControlWriter {
 public:
  explicit ControlWriter(Participant& participant);
  ~ControlWriter();
  bool Publish(const RunControl& control);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
