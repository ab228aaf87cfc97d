#pragma once
// What all processes of the run report of themselves. Thread-compatible. The participant must
// outlive it.
#include <memory>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class ReportReader {
 public:
  explicit ReportReader(Participant& participant);
  ~ReportReader();
  [[nodiscard]] bool Take(ProcessReport& report);  // the next one, if there is one
  void Wait(std::chrono::milliseconds at_most);    // until something has come

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
