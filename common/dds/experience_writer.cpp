#include "common/dds/experience_writer.h"

#include <creditPubSubTypes.h>
#include <experiencePubSubTypes.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/dds/typed_entity.h"
#include "common/rl/delivery_window.h"

namespace ronda::dds {

using Clock = std::chrono::steady_clock;

std::uint32_t TransitionsInMessage(const TransitionShape& shape) {
  const auto fit = [](std::uint32_t most, std::uint32_t each) {
    return each == 0 ? wire::MAX_TRANSITIONS : most / each;
  };
  return std::min({wire::MAX_TRANSITIONS, fit(wire::MAX_OBSERVATION_FLOATS, shape.observation_size),
                   fit(wire::MAX_LEGAL_FLAGS, shape.num_actions),
                   fit(wire::MAX_EXTRA_FLOATS, shape.extras_size)});
}

namespace {

DeliveryOptions ToDelivery(const ExperienceWriterOptions& options) {
  const std::uint32_t most = TransitionsInMessage(options.shape);
  if (most == 0) {
    throw TransportError(fmt::format(
        "a transition of {} observation floats and {} actions is too large for a message",
        options.shape.observation_size, options.shape.num_actions));
  }
  DeliveryOptions delivery;
  delivery.actor = options.actor;
  delivery.incarnation = options.incarnation;
  delivery.shape = options.shape;
  delivery.batch_size = std::min(options.batch_size, most);
  delivery.max_age = options.max_age;
  delivery.max_batches = kMaxUnconfirmedBatches;
  return delivery;
}

}  // namespace

struct ExperienceWriter::Impl {
  Impl(Participant& participant, const ExperienceWriterOptions& options)
      : window(ToDelivery(options)),
        experience(participant.impl(), kExperienceChannel),
        credit(participant.impl(), kCreditChannel, wakeup) {}

  void Poll() {
    const auto now = Clock::now();
    while (credit.Take(status, refusals)) window.OnStatus(status, now);
    while (const TransitionBatch* batch = window.NextToSend(now)) {
      if (!experience.Write(*batch)) break;
      window.MarkSent(now);
    }
  }

  DeliveryWindow window;
  Wakeup wakeup;
  Refusals refusals;
  ReplayStatus status;
  TypedWriter<wire::TransitionBatchPubSubType> experience;
  TypedReader<wire::ReplayStatusPubSubType> credit;
};

ExperienceWriter::ExperienceWriter(Participant& participant, const ExperienceWriterOptions& options)
    : impl_(std::make_unique<Impl>(participant, options)) {}

ExperienceWriter::~ExperienceWriter() = default;

PushResult ExperienceWriter::Push(const Transition& transition) {
  return impl_->window.Push(transition, Clock::now());
}

void ExperienceWriter::Poll() { impl_->Poll(); }

void ExperienceWriter::Wait(std::chrono::milliseconds at_most) {
  impl_->wakeup.Wait(at_most);
  impl_->Poll();
}

bool ExperienceWriter::Drain(std::chrono::milliseconds at_most) {
  const auto deadline = Clock::now() + at_most;
  impl_->window.Flush();
  impl_->Poll();
  while (!impl_->window.all_confirmed() && Clock::now() < deadline) {
    Wait(std::chrono::milliseconds(10));
  }
  return impl_->window.all_confirmed();
}

std::uint64_t ExperienceWriter::sent() const { return impl_->window.sent(); }

std::uint64_t ExperienceWriter::confirmed() const { return impl_->window.confirmed(); }

std::string ExperienceWriter::waiting_for() const {
  return impl_->window.named() ? "credit from the replay" : "the replay";
}

}  // namespace ronda::dds
