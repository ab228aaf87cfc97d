#include "common/dds/weights_writer.h"

#include <weightsPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct WeightsWriter::Impl {
  explicit Impl(Participant& participant) : weights(participant.impl(), kWeightsChannel) {}
  TypedWriter<wire::WeightSnapshotPubSubType> weights;
};

WeightsWriter::WeightsWriter(Participant& participant)
    : impl_(std::make_unique<Impl>(participant)) {}

WeightsWriter::~WeightsWriter() = default;

void WeightsWriter::Publish(const WeightSnapshot& snapshot) {
  // The next one follows soon; nothing waits for this one.
  [[maybe_unused]] const bool sent = impl_->weights.Write(snapshot);
}

}  // namespace ronda::dds
