#include "common/dds/report_writer.h"

#include <telemetryPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct ReportWriter::Impl {
  explicit Impl(Participant& participant) : reports(participant.impl(), kReportChannel) {}
  TypedWriter<wire::ProcessReportPubSubType> reports;
};

ReportWriter::ReportWriter(Participant& participant) : impl_(std::make_unique<Impl>(participant)) {}

ReportWriter::~ReportWriter() = default;

bool ReportWriter::Send(const ProcessReport& report) { return impl_->reports.Write(report); }

void ReportWriter::Flush(std::chrono::milliseconds at_most) {
  impl_->reports.WaitForAcknowledgments(at_most);
}

}  // namespace ronda::dds
