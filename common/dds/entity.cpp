#include "common/dds/entity.h"

#include <fmt/format.h>

#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <sstream>

#include "common/base/error.h"

namespace ronda::dds {
namespace {

using eprosima::fastrtps::types::ReturnCode_t;

// The one place that knows how this version of the library says "done".
bool Succeeded(const ReturnCode_t& code) { return code == ReturnCode_t::RETCODE_OK; }

}  // namespace

WriterEntity::WriterEntity(Participant::Impl& participant, const Channel& channel,
                           fastdds::TypeSupport type)
    : participant_(participant), topic_(channel.topic), type_(std::move(type)) {
  fastdds::Topic* topic = participant.TopicNamed(channel.topic, type_);
  participant.CountWritten(topic_, 0, 0);
  writer_ = participant.publisher->create_datawriter(topic, WriterQos(channel));
  if (writer_ == nullptr) {
    throw TransportError(fmt::format("DDS domain {}: no writer could be made for topic '{}'",
                                     participant.domain, channel.topic));
  }
}

WriterEntity::~WriterEntity() { participant_.publisher->delete_datawriter(writer_); }

bool WriterEntity::WriteSample(void* sample) {
  if (!Succeeded(writer_->write(sample, fastdds::HANDLE_NIL))) return false;
  participant_.CountWritten(topic_, 1, type_.get_serialized_size_provider(sample)());
  return true;
}

bool WriterEntity::WaitForAcknowledgments(std::chrono::milliseconds at_most) {
  return Succeeded(writer_->wait_for_acknowledgments(
      eprosima::fastrtps::Duration_t(static_cast<long double>(at_most.count()) / 1000.0L)));
}

ReaderEntity::ReaderEntity(Participant::Impl& participant, const Channel& channel,
                           fastdds::TypeSupport type, Wakeup& wakeup)
    : participant_(participant), topic_(channel.topic), listener_(wakeup) {
  fastdds::Topic* topic = participant.TopicNamed(channel.topic, std::move(type));
  reader_ = participant.subscriber->create_datareader(topic, ReaderQos(channel), &listener_,
                                                      fastdds::StatusMask::data_available());
  if (reader_ == nullptr) {
    throw TransportError(fmt::format("DDS domain {}: no reader could be made for topic '{}'",
                                     participant.domain, channel.topic));
  }
}

ReaderEntity::~ReaderEntity() {
  reader_->set_listener(nullptr);
  participant_.subscriber->delete_datareader(reader_);
}

bool ReaderEntity::TakeSample(void* sample) {
  fastdds::SampleInfo info;
  while (Succeeded(reader_->take_next_sample(sample, &info))) {
    if (!info.valid_data) continue;  // only says that a writer went away
    last_sender_ = info.sample_identity.writer_guid();
    return true;
  }
  return false;
}

std::string ReaderEntity::LastSender() const {
  std::ostringstream text;
  text << last_sender_;
  return text.str();
}

}  // namespace ronda::dds
