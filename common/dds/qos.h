#pragma once
// The quality of service of every topic, in one place. Private to common/dds.
//
// All topics are reliable. Writers keep the last `writer_depth` samples instead of all: a writer
// that keeps all stands still for every reader while one of them is dead and its lease runs, and
// nothing here needs that, since delivery is confirmed end to end (experience), asked for again
// (sampling), or only the newest counts (the rest). So no write waits for a reader.
// Readers have room for far more than is ever unread: what a killed writer left incomplete (a
// sample that came after a lost one) keeps its place until that writer's lease ends, and where such
// samples fill a reader, its successor is not heard for that long. The table is explained in
// docs/protocol.md.
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

namespace ronda::dds {

enum class Durability { kVolatile, kTransientLocal };

struct Channel {
  const char* topic;
  Durability durability;
  int writer_depth;  // samples
  int reader_depth;  // samples; beyond it the reader refuses (keep all), or drops the oldest
  bool reader_keeps_all;
};

/// Unconfirmed batches of one actor; with DeliveryWindow's repeats at most twice these are written.
inline constexpr int kMaxUnconfirmedBatches = 64;

inline constexpr Channel kExperienceChannel{.topic = "ronda/experience",
                                            .durability = Durability::kVolatile,
                                            .writer_depth = 2 * kMaxUnconfirmedBatches,
                                            .reader_depth = 128 * kMaxUnconfirmedBatches,
                                            .reader_keeps_all = true};
inline constexpr Channel kCreditChannel{.topic = "ronda/credit",
                                        .durability = Durability::kTransientLocal,
                                        .writer_depth = 1,
                                        .reader_depth = 128,
                                        .reader_keeps_all = false};
inline constexpr Channel kRequestChannel{.topic = "ronda/sample_request",
                                         .durability = Durability::kTransientLocal,
                                         .writer_depth = 1,
                                         .reader_depth = 128,
                                         .reader_keeps_all = false};
inline constexpr Channel kSampleChannel{.topic = "ronda/sample",
                                        .durability = Durability::kVolatile,
                                        .writer_depth = 64,
                                        .reader_depth = 512,
                                        .reader_keeps_all = true};
inline constexpr Channel kPriorityChannel{.topic = "ronda/priorities",
                                          .durability = Durability::kVolatile,
                                          .writer_depth = 64,
                                          .reader_depth = 256,
                                          .reader_keeps_all = true};
inline constexpr Channel kWeightsChannel{.topic = "ronda/weights",
                                         .durability = Durability::kTransientLocal,
                                         .writer_depth = 1,
                                         .reader_depth = 32,
                                         .reader_keeps_all = false};
inline constexpr Channel kReportChannel{.topic = "ronda/report",
                                        .durability = Durability::kTransientLocal,
                                        .writer_depth = 1,
                                        .reader_depth = 1024,
                                        .reader_keeps_all = false};
inline constexpr Channel kControlChannel{.topic = "ronda/control",
                                         .durability = Durability::kTransientLocal,
                                         .writer_depth = 1,
                                         .reader_depth = 128,
                                         .reader_keeps_all = false};

eprosima::fastdds::dds::DataWriterQos WriterQos(const Channel& channel);
eprosima::fastdds::dds::DataReaderQos ReaderQos(const Channel& channel);

}  // namespace ronda::dds
