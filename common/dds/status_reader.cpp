#include "common/dds/status_reader.h"

#include <creditPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct StatusReader::Impl {
  explicit Impl(Participant& participant) : statuses(participant.impl(), kCreditChannel, wakeup) {}
  Wakeup wakeup;
  Refusals refusals;
  TypedReader<wire::ReplayStatusPubSubType> statuses;
};

StatusReader::StatusReader(Participant& participant) : impl_(std::make_unique<Impl>(participant)) {}

StatusReader::~StatusReader() = default;

bool StatusReader::Take(ReplayStatus& status) {
  return impl_->statuses.Take(status, impl_->refusals);
}

void StatusReader::Wait(std::chrono::milliseconds at_most) { impl_->wakeup.Wait(at_most); }

}  // namespace ronda::dds
