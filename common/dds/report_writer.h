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
  /// With the process's traffic among the metrics.
  bool Send(ProcessReport report);
  /// Waits until every reader that is there has the last report.
  void Flush(std::chrono::milliseconds at_most);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Appends what the process has written to each topic: "messages ronda/experience", "bytes …".
void AddTraffic(const Participant& participant, ProcessReport& report);

}  // namespace ronda::dds
