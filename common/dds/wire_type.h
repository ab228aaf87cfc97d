#pragma once
// The generated type support of a message, made safe against bytes that are no such message.
// Private to common/dds.
//
// A payload that cannot be read yields a value whose protocol version is 0 (no such version
// exists), so that it reaches the codec and is refused and counted there. Payloads start small and
// grow with what is sent: a bounded type's largest size, here up to 8 MB a sample, is never set
// aside.
#include <exception>

namespace ronda::dds {

template <typename PubSubType>
class WireType : public PubSubType {
 public:
  using Value = typename PubSubType::type;

  WireType() { this->m_typeSize = kFirstPayloadBytes; }

  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    try {
      if (PubSubType::deserialize(payload, data)) return true;
    } catch (const std::exception&) {  // bad encapsulation, bad lengths, no memory
    }
    *static_cast<Value*>(data) = Value();
    return true;
  }

 private:
  static constexpr std::uint32_t kFirstPayloadBytes = 512;
};

}  // namespace ronda::dds
