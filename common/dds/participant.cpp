#include "common/dds/participant.h"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fmt/format.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>

#include <algorithm>
#include <mutex>

#include "common/base/error.h"
#include "common/dds/loopback.h"
#include "common/dds/participant_impl.h"

namespace ronda::dds {
namespace {

using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::rtps::IPLocator;
using eprosima::fastrtps::rtps::Locator_t;

constexpr const char* kLoopback = "127.0.0.1";

/// Settings that the library keeps for the whole process: its own log is silent (what matters
/// reaches us as a return value), and two participants of one process talk as two processes do.
void SetUpLibraryOnce() {
  static std::once_flag once;
  std::call_once(once, [] {
    fastdds::Log::ClearConsumers();
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  });
}

Duration_t ToDuration(std::chrono::milliseconds value) {
  return Duration_t(static_cast<long double>(value.count()) / 1000.0L);
}

Locator_t LoopbackLocator() {
  Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  IPLocator::setIPv4(locator, kLoopback);
  return locator;  // port 0: the well-known ones of the domain
}

fastdds::DomainParticipantQos ToQos(const ParticipantOptions& options) {
  fastdds::DomainParticipantQos qos = fastdds::PARTICIPANT_QOS_DEFAULT;
  qos.name(options.name.c_str());

  auto transport = std::make_shared<UDPv4TransportDescriptor>();
  transport->interfaceWhiteList = {kLoopback};
  transport->sendBufferSize = static_cast<std::uint32_t>(options.socket_buffer_bytes);
  transport->receiveBufferSize = static_cast<std::uint32_t>(options.socket_buffer_bytes);
  transport->maxInitialPeersRange = kMaxParticipants;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {transport};

  auto& wire = qos.wire_protocol();
  // Given a unicast list, the library joins no multicast group, which may not exist on `lo`.
  wire.builtin.metatrafficUnicastLocatorList.push_back(LoopbackLocator());
  wire.builtin.initialPeersList.push_back(LoopbackLocator());
  auto& discovery = wire.builtin.discovery_config;
  discovery.leaseDuration = ToDuration(options.participant_lease);
  discovery.leaseDuration_announcementperiod =
      ToDuration(std::min(options.participant_lease / 4, std::chrono::milliseconds(1000)));
  discovery.initial_announcements.count = 5;
  discovery.initial_announcements.period = ToDuration(std::chrono::milliseconds(100));
  return qos;
}

}  // namespace

Participant::Impl::Impl(const ParticipantOptions& options) : domain(options.domain) {
  if (domain < 0 || domain > kMaxDomain) {
    throw TransportError(
        fmt::format("DDS domain {} is not one of 0 … {}", options.domain, kMaxDomain));
  }
  if (!LoopbackIsUp()) {
    throw TransportError(fmt::format(
        "DDS domain {} cannot be joined: there is no way to {}; is the loopback interface up?",
        domain, kLoopback));
  }
  SetUpLibraryOnce();
  socket_buffer_report = DescribeSocketBuffers(options.socket_buffer_bytes,
                                               ProbeSocketBuffers(options.socket_buffer_bytes));
  participant = fastdds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<std::uint32_t>(domain), ToQos(options));
  if (participant == nullptr) {
    throw TransportError(fmt::format(
        "DDS domain {} cannot be joined over {}: is the loopback interface up, and is "
        "one of the UDP ports {} … {} free?",
        domain, kLoopback, 7400 + 250 * domain, 7400 + 250 * domain + 11 + 2 * kMaxParticipants));
  }
  fastdds::PublisherQos publisher_qos = fastdds::PUBLISHER_QOS_DEFAULT;
  publisher_qos.partition().push_back(options.run_id.c_str());
  publisher = participant->create_publisher(publisher_qos);
  fastdds::SubscriberQos subscriber_qos = fastdds::SUBSCRIBER_QOS_DEFAULT;
  subscriber_qos.partition().push_back(options.run_id.c_str());
  subscriber = participant->create_subscriber(subscriber_qos);
  if (publisher == nullptr || subscriber == nullptr) {
    Close();
    throw TransportError(
        fmt::format("DDS domain {}: no publisher or subscriber for run '{}' could be made", domain,
                    options.run_id));
  }
}

Participant::Impl::~Impl() { Close(); }

void Participant::Impl::Close() {
  if (participant == nullptr) return;
  participant->delete_contained_entities();
  fastdds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  participant = nullptr;
}

fastdds::Topic* Participant::Impl::TopicNamed(const std::string& name, fastdds::TypeSupport type) {
  const std::lock_guard lock(mutex_);
  if (const auto found = topics_.find(name); found != topics_.end()) return found->second;
  type.register_type(participant);
  fastdds::Topic* topic =
      participant->create_topic(name, type.get_type_name(), fastdds::TOPIC_QOS_DEFAULT);
  if (topic == nullptr) {
    throw TransportError(fmt::format("DDS domain {}: topic '{}' of type '{}' could not be made",
                                     domain, name, type.get_type_name()));
  }
  topics_[name] = topic;
  return topic;
}

void Participant::Impl::CountWritten(const std::string& topic, std::uint64_t messages,
                                     std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  Traffic& traffic = written_[topic];
  traffic.topic = topic;
  traffic.messages += messages;
  traffic.bytes += bytes;
}

std::vector<Traffic> Participant::Impl::Written() const {
  const std::lock_guard lock(mutex_);
  std::vector<Traffic> written;
  for (const auto& [topic, traffic] : written_) written.push_back(traffic);
  return written;
}

Participant::Participant(const ParticipantOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}

Participant::~Participant() = default;

std::vector<Traffic> Participant::Written() const { return impl_->Written(); }

const std::string& Participant::socket_buffer_report() const { return impl_->socket_buffer_report; }

}  // namespace ronda::dds
