#pragma once
// The Fast DDS side of a Participant: participant, publisher, subscriber, and one topic for each
// name. Private to common/dds. Thread-safe.
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "common/dds/participant.h"

namespace ronda::dds {

namespace fastdds = eprosima::fastdds::dds;

struct Participant::Impl {
  explicit Impl(const ParticipantOptions& options);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// The topic of this name, made at the first call; throws TransportError.
  fastdds::Topic* TopicNamed(const std::string& name, fastdds::TypeSupport type);

  /// Adds to what was written to the topic.
  void CountWritten(const std::string& topic, std::uint64_t messages, std::uint64_t bytes);
  std::vector<Traffic> Written() const;

  int domain;
  std::string socket_buffer_report;
  fastdds::DomainParticipant* participant = nullptr;
  fastdds::Publisher* publisher = nullptr;
  fastdds::Subscriber* subscriber = nullptr;

 private:
  void Close();

  mutable std::mutex mutex_;
  std::map<std::string, fastdds::Topic*> topics_;
  std::map<std::string, Traffic> written_;
};

}  // namespace ronda::dds
