#include "common/dds/report_writer.h"

#include <telemetryPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct ReportWriter::Impl {
  explicit Impl(Participant& process)
      : participant(process), reports(process.impl(), kReportChannel) {}
  Participant& participant;
  TypedWriter<wire::ProcessReportPubSubType> reports;
};

ReportWriter::ReportWriter(Participant& participant) : impl_(std::make_unique<Impl>(participant)) {}

ReportWriter::~ReportWriter() = default;

bool ReportWriter::Send(ProcessReport report) {
  AddTraffic(impl_->participant, report);
  return impl_->reports.Write(report);
}

void AddTraffic(const Participant& participant, ProcessReport& report) {
  for (const Traffic& traffic : participant.Written()) {
    report.metrics.emplace_back(kMessagesMetric + traffic.topic,
                                static_cast<double>(traffic.messages));
    report.metrics.emplace_back(kBytesMetric + traffic.topic, static_cast<double>(traffic.bytes));
  }
}

void ReportWriter::Flush(std::chrono::milliseconds at_most) {
  impl_->reports.WaitForAcknowledgments(at_most);
}

}  // namespace ronda::dds
