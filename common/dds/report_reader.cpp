#include "common/dds/report_reader.h"

#include <telemetryPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct ReportReader::Impl {
  explicit Impl(Participant& participant) : reports(participant.impl(), kReportChannel, wakeup) {}
  Wakeup wakeup;
  Refusals refusals;
  TypedReader<wire::ProcessReportPubSubType> reports;
};

ReportReader::ReportReader(Participant& participant) : impl_(std::make_unique<Impl>(participant)) {}

ReportReader::~ReportReader() = default;

bool ReportReader::Take(ProcessReport& report) {
  return impl_->reports.Take(report, impl_->refusals);
}

void ReportReader::Wait(std::chrono::milliseconds at_most) { impl_->wakeup.Wait(at_most); }

}  // namespace ronda::dds
