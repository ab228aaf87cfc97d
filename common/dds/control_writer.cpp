#include "common/dds/control_writer.h"

#include <controlPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct ControlWriter::Impl {
  explicit Impl(Participant& participant) : control(participant.impl(), kControlChannel) {}
  TypedWriter<wire::RunControlPubSubType> control;
};

ControlWriter::ControlWriter(Participant& participant)
    : impl_(std::make_unique<Impl>(participant)) {}

ControlWriter::~ControlWriter() = default;

bool ControlWriter::Publish(const RunControl& control) { return impl_->control.Write(control); }

}  // namespace ronda::dds
