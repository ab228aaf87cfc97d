#pragma once
// A DDS writer and a DDS reader, each owning its entity. Private to common/dds.
//
// The participant must outlive them. Construction throws TransportError. A listener only notifies
// the Wakeup: samples are taken by the thread that owns the reader. Thread-compatible.
#include <chrono>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <string>

#include "common/dds/participant_impl.h"
#include "common/dds/qos.h"
#include "common/dds/wakeup.h"

namespace ronda::dds {

class WriterEntity {
 public:
  WriterEntity(Participant::Impl& participant, const Channel& channel, fastdds::TypeSupport type);
  ~WriterEntity();
  WriterEntity(const WriterEntity&) = delete;
  WriterEntity& operator=(const WriterEntity&) = delete;

  /// False: try the same again later.
  [[nodiscard]] bool WriteSample(void* sample);
  /// True when every matched reader has received all that was written.
  bool WaitForAcknowledgments(std::chrono::milliseconds at_most);

 private:
  Participant::Impl& participant_;
  std::string topic_;
  fastdds::TypeSupport type_;
  fastdds::DataWriter* writer_;
};

class ReaderEntity {
 public:
  ReaderEntity(Participant::Impl& participant, const Channel& channel, fastdds::TypeSupport type,
               Wakeup& wakeup);
  ~ReaderEntity();
  ReaderEntity(const ReaderEntity&) = delete;
  ReaderEntity& operator=(const ReaderEntity&) = delete;

  /// The next sample, if there is one.
  [[nodiscard]] bool TakeSample(void* sample);
  /// Names the writer of what was taken last.
  std::string LastSender() const;
  const char* topic() const { return topic_; }

 private:
  class Listener : public fastdds::DataReaderListener {
   public:
    explicit Listener(Wakeup& wakeup) : wakeup_(wakeup) {}
    void on_data_available(fastdds::DataReader*) override { wakeup_.Notify(); }

   private:
    Wakeup& wakeup_;
  };

  Participant::Impl& participant_;
  const char* topic_;
  Listener listener_;
  fastdds::DataReader* reader_;
  eprosima::fastrtps::rtps::GUID_t last_sender_;
};

}  // namespace ronda::dds
