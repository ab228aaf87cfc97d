#pragma once
// The replay's status, for who only watches. Thread-compatible. The participant must outlive it.
#include <memory>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class StatusReader {
 public:
  explicit StatusReader(Participant& participant);
  ~StatusReader();
  [[nodiscard]] bool Take(ReplayStatus& status);  // the next one, if there is one
  void Wait(std::chrono::milliseconds at_most);   // until something has come

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
