#include "common/dds/weights_reader.h"

#include <fmt/format.h>
#include <weightsPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct WeightsReader::Impl {
  Impl(Participant& participant, std::uint64_t hash)
      : architecture_hash(hash), weights(participant.impl(), kWeightsChannel, wakeup) {}

  std::uint64_t architecture_hash;
  Wakeup wakeup;
  Refusals refusals;
  TypedReader<wire::WeightSnapshotPubSubType> weights;
  WeightSnapshot newest, incoming;
};

WeightsReader::WeightsReader(Participant& participant, std::uint64_t architecture_hash)
    : impl_(std::make_unique<Impl>(participant, architecture_hash)) {}

WeightsReader::~WeightsReader() = default;

const WeightSnapshot* WeightsReader::Newest() {
  bool newer = false;
  while (impl_->weights.Take(impl_->incoming, impl_->refusals)) {
    if (impl_->incoming.architecture_hash != impl_->architecture_hash) {
      impl_->refusals.Add(impl_->weights.topic(), impl_->weights.sender(),
                          fmt::format("weights of architecture {:016x}, this is {:016x}",
                                      impl_->incoming.architecture_hash, impl_->architecture_hash));
      continue;
    }
    if (impl_->incoming.version <= impl_->newest.version) continue;
    std::swap(impl_->newest, impl_->incoming);
    newer = true;
  }
  return newer ? &impl_->newest : nullptr;
}

void WeightsReader::Wait(std::chrono::milliseconds at_most) { impl_->wakeup.Wait(at_most); }

std::uint64_t WeightsReader::messages_refused() const { return impl_->refusals.count(); }

std::vector<std::string> WeightsReader::TakeRefusals() { return impl_->refusals.Take(); }

}  // namespace ronda::dds
