#include "common/dds/qos.h"

#include <algorithm>

namespace ronda::dds {
namespace {

namespace fastdds = eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;

constexpr std::uint32_t kMillisecond_ns = 1'000'000;
constexpr int kAllocatedSamples = 2;  // at first; more are made when they are needed

Duration_t Milliseconds(std::uint32_t value) { return Duration_t(0, value * kMillisecond_ns); }

/// What readers and writers must agree on.
template <typename Qos>
void SetCommon(Qos& qos, const Channel& channel) {
  qos.reliability().kind = fastdds::RELIABLE_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = Milliseconds(200);
  qos.durability().kind = channel.durability == Durability::kTransientLocal
                              ? fastdds::TRANSIENT_LOCAL_DURABILITY_QOS
                              : fastdds::VOLATILE_DURABILITY_QOS;
  qos.liveliness().kind = fastdds::AUTOMATIC_LIVELINESS_QOS;
  qos.liveliness().lease_duration = Duration_t(1, 0);
  qos.liveliness().announcement_period = Milliseconds(300);
  qos.endpoint().history_memory_policy = PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
}

template <typename Qos>
void SetDepth(Qos& qos, int depth, bool keep_all) {
  qos.history().kind = keep_all ? fastdds::KEEP_ALL_HISTORY_QOS : fastdds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  auto& limits = qos.resource_limits();
  limits.max_samples = depth;
  limits.max_instances = 1;
  limits.max_samples_per_instance = depth;
  limits.allocated_samples = std::min(depth, kAllocatedSamples);
}

}  // namespace

fastdds::DataWriterQos WriterQos(const Channel& channel) {
  fastdds::DataWriterQos qos = fastdds::DATAWRITER_QOS_DEFAULT;
  SetCommon(qos, channel);
  SetDepth(qos, channel.writer_depth, /*keep_all=*/false);
  qos.publish_mode().kind = fastdds::SYNCHRONOUS_PUBLISH_MODE;
  auto& times = qos.reliable_writer_qos().times;
  times.heartbeatPeriod = Milliseconds(100);
  times.nackResponseDelay = Duration_t(0, 0);
  return qos;
}

fastdds::DataReaderQos ReaderQos(const Channel& channel) {
  fastdds::DataReaderQos qos = fastdds::DATAREADER_QOS_DEFAULT;
  SetCommon(qos, channel);
  SetDepth(qos, channel.reader_depth, channel.reader_keeps_all);
  qos.reliable_reader_qos().times.heartbeatResponseDelay = Duration_t(0, 0);
  return qos;
}

}  // namespace ronda::dds
