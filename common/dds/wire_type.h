#pragma once
// The generated type support of a message, made safe against bytes that are no such message.
// Private to common/dds.
//
// A payload that cannot be read yields a value whose protocol version is 0 (no such version
// exists), so that it reaches the codec and is refused and counted there. (The library serialises
// into payloads of the type's largest size, whatever is sent: qos.h keeps few of them at first, and
// pages that are not written to are never made.)
#include <fastdds/rtps/common/SerializedPayload.h>

#include <exception>

namespace ronda::dds {

template <typename PubSubType>
class WireType : public PubSubType {
 public:
  using Value = typename PubSubType::type;

  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    try {
      if (PubSubType::deserialize(payload, data)) return true;
    } catch (const std::exception&) {  // bad encapsulation, bad lengths, no memory
    }
    *static_cast<Value*>(data) = Value();
    return true;
  }
};

}  // namespace ronda::dds
