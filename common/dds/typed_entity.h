#pragma once
// A writer and a reader of one topic that speak plain values. Private to common/dds.
// Thread-compatible.
#include <string>

#include "common/dds/codec.h"
#include "common/dds/entity.h"
#include "common/dds/refusals.h"
#include "common/dds/wire_type.h"

namespace ronda::dds {

template <typename PubSubType>
class TypedWriter {
 public:
  TypedWriter(Participant::Impl& participant, const Channel& channel)
      : entity_(participant, channel, fastdds::TypeSupport(new WireType<PubSubType>())) {}

  /// False: too large for its message, or not taken by the writer; nothing was sent.
  template <typename Value>
  [[nodiscard]] bool Write(const Value& value) {
    return Encode(value, message_) && entity_.WriteSample(&message_);
  }

  bool WaitForAcknowledgments(std::chrono::milliseconds at_most) {
    return entity_.WaitForAcknowledgments(at_most);
  }

 private:
  WriterEntity entity_;
  typename PubSubType::type message_;
};

template <typename PubSubType>
class TypedReader {
 public:
  TypedReader(Participant::Impl& participant, const Channel& channel, Wakeup& wakeup)
      : entity_(participant, channel, fastdds::TypeSupport(new WireType<PubSubType>()), wakeup) {}

  /// The next message that decodes; what does not goes to `refusals`.
  template <typename Value>
  [[nodiscard]] bool Take(Value& value, Refusals& refusals) {
    while (entity_.TakeSample(&message_)) {
      const Fault fault = Decode(message_, value);
      if (fault == Fault::kNone) return true;
      refusals.Add(entity_.topic(), sender(), Describe(fault));
    }
    return false;
  }

  std::string sender() const { return entity_.LastSender(); }  // of what was taken last
  const char* topic() const { return entity_.topic(); }

 private:
  ReaderEntity entity_;
  typename PubSubType::type message_;
};

}  // namespace ronda::dds
