#include "common/dds/learner_endpoint.h"

#include <samplingPubSubTypes.h>

#include <algorithm>

#include "common/dds/typed_entity.h"

namespace ronda::dds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kRepeatRequest{500};  // while nothing comes

}  // namespace

struct LearnerEndpoint::Impl {
  Impl(Participant& participant, const LearnerEndpointOptions& options_in)
      : options(options_in),
        requests(participant.impl(), kRequestChannel),
        samples(participant.impl(), kSampleChannel, wakeup),
        priorities(participant.impl(), kPriorityChannel) {
    request.learner_incarnation = options.learner_incarnation;
    request.batch_size = options.batch_size;
  }

  /// Asks for everything from the lowest id that has not come.
  void Ask(Clock::time_point now) {
    request.end_id = request.first_id + static_cast<std::uint64_t>(options.outstanding);
    if (requests.Write(request)) asked_at = now;
  }

  bool TakeOne() {
    while (samples.Take(batch, refusals)) {
      const bool wanted = batch.learner_incarnation == options.learner_incarnation &&
                          batch.id >= request.first_id && batch.id < request.end_id;
      if (!wanted) continue;            // another learner's, or given up
      request.first_id = batch.id + 1;  // one replay sends in order: what it skipped is lost
      return true;
    }
    return false;
  }

  LearnerEndpointOptions options;
  Wakeup wakeup;
  Refusals refusals;
  TypedWriter<wire::SampleRequestPubSubType> requests;
  TypedReader<wire::SampledBatchPubSubType> samples;
  TypedWriter<wire::PriorityUpdatePubSubType> priorities;
  SampleRequest request;  // [first_id, end_id) are outstanding
  SampledBatch batch;
  Clock::time_point asked_at{};
  Clock::time_point came_at = Clock::now();
};

LearnerEndpoint::LearnerEndpoint(Participant& participant, const LearnerEndpointOptions& options)
    : impl_(std::make_unique<Impl>(participant, options)) {}

LearnerEndpoint::~LearnerEndpoint() = default;

const SampledBatch* LearnerEndpoint::Next(std::chrono::milliseconds at_most) {
  Impl& impl = *impl_;
  const auto deadline = Clock::now() + at_most;
  for (;;) {
    const bool took = impl.TakeOne();
    const auto now = Clock::now();
    if (took) impl.came_at = now;
    const auto outstanding =
        impl.request.end_id - std::min(impl.request.end_id, impl.request.first_id);
    const auto half = static_cast<std::uint64_t>(impl.options.outstanding) / 2;
    if (now - impl.came_at >= impl.options.request_timeout) {
      impl.request.first_id = impl.request.end_id;  // lost: ask for new ones
      impl.came_at = now;
      impl.Ask(now);
    } else if (outstanding <= half || (!took && now - impl.asked_at >= kRepeatRequest)) {
      impl.Ask(now);
    }
    if (took) return &impl.batch;
    if (now >= deadline) return nullptr;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - now);
    impl.wakeup.Wait(std::min(left, kRepeatRequest));  // then it may be time to ask again
  }
}

void LearnerEndpoint::Push(const PriorityUpdate& update) {
  // A lost update leaves old priorities: no harm.
  [[maybe_unused]] const bool sent = impl_->priorities.Write(update);
}

std::uint64_t LearnerEndpoint::messages_refused() const { return impl_->refusals.count(); }

std::vector<std::string> LearnerEndpoint::TakeRefusals() { return impl_->refusals.Take(); }

}  // namespace ronda::dds
