#pragma once
// What this process reports of itself; the newest counts. Thread-compatible. The participant must
// outlive it.
#include <memory>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class ReportWriter {
 public:
  explicit ReportWriter(Participant& participant);
  ~ReportWriter();
  bool Send(const ProcessReport& report);
  /// Waits until every reader that is there has the last report.
  void Flush(std::chrono::milliseconds at_most);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
