#include "common/dds/control_reader.h"

#include <controlPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct ControlReader::Impl {
  explicit Impl(Participant& participant) : control(participant.impl(), kControlChannel, wakeup) {}
  Wakeup wakeup;
  Refusals refusals;
  TypedReader<wire::RunControlPubSubType> control;
  RunControl newest;
};

ControlReader::ControlReader(Participant& participant)
    : impl_(std::make_unique<Impl>(participant)) {}

ControlReader::~ControlReader() = default;

const RunControl* ControlReader::Newest() {
  bool news = false;
  while (impl_->control.Take(impl_->newest, impl_->refusals)) news = true;
  return news ? &impl_->newest : nullptr;
}

}  // namespace ronda::dds
