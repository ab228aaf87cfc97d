#include "common/dds/replay_endpoint.h"

#include <creditPubSubTypes.h>
#include <experiencePubSubTypes.h>
#include <samplingPubSubTypes.h>

#include "common/dds/typed_entity.h"

namespace ronda::dds {

struct ReplayEndpoint::Impl {
  explicit Impl(Participant& participant)
      : experience(participant.impl(), kExperienceChannel, wakeup),
        requests(participant.impl(), kRequestChannel, wakeup),
        priorities(participant.impl(), kPriorityChannel, wakeup),
        credit(participant.impl(), kCreditChannel),
        samples(participant.impl(), kSampleChannel) {}

  Wakeup wakeup;
  Refusals refusals;
  TypedReader<wire::TransitionBatchPubSubType> experience;
  TypedReader<wire::SampleRequestPubSubType> requests;
  TypedReader<wire::PriorityUpdatePubSubType> priorities;
  TypedWriter<wire::ReplayStatusPubSubType> credit;
  TypedWriter<wire::SampledBatchPubSubType> samples;
};

ReplayEndpoint::ReplayEndpoint(Participant& participant)
    : impl_(std::make_unique<Impl>(participant)) {}

ReplayEndpoint::~ReplayEndpoint() = default;

bool ReplayEndpoint::TakeBatch(TransitionBatch& batch) {
  return impl_->experience.Take(batch, impl_->refusals);
}

bool ReplayEndpoint::TakeRequest(SampleRequest& request) {
  return impl_->requests.Take(request, impl_->refusals);
}

bool ReplayEndpoint::TakePriorities(PriorityUpdate& update) {
  return impl_->priorities.Take(update, impl_->refusals);
}

bool ReplayEndpoint::SendStatus(const ReplayStatus& status) { return impl_->credit.Write(status); }

bool ReplayEndpoint::SendBatch(const SampledBatch& batch) { return impl_->samples.Write(batch); }

void ReplayEndpoint::Wait(std::chrono::milliseconds at_most) { impl_->wakeup.Wait(at_most); }

void ReplayEndpoint::Flush(std::chrono::milliseconds at_most) {
  impl_->credit.WaitForAcknowledgments(at_most);
}

std::uint64_t ReplayEndpoint::messages_refused() const { return impl_->refusals.count(); }

std::vector<std::string> ReplayEndpoint::TakeRefusals() { return impl_->refusals.Take(); }

}  // namespace ronda::dds
