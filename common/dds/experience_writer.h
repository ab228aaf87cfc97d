#pragma once
// The actor's way to the replay: transitions out, credit back, delivery confirmed end to end.
//
// Contract as rl/ports.h; the rules are rl/delivery_window's. `Poll` sends what is due. Nothing
// blocks but Wait and Drain, as long as they are told. The participant must outlive it.
#include <memory>
#include <string>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

struct ExperienceWriterOptions {
  std::uint32_t actor = 0;
  std::uint64_t incarnation = 0;
  TransitionShape shape;
  std::uint32_t batch_size = 256;         // lowered to what fits into one message
  std::chrono::milliseconds max_age{10};  // of a batch that is not full
};

class ExperienceWriter final : public TransitionSink {
 public:
  /// TransportError where not even one transition of this shape fits into a message.
  ExperienceWriter(Participant& participant, const ExperienceWriterOptions& options);
  ~ExperienceWriter() override;

  PushResult Push(const Transition& transition) override;
  void Poll() override;
  void Wait(std::chrono::milliseconds at_most) override;
  /// Sends everything and waits until it is confirmed; false where the time was too short.
  bool Drain(std::chrono::milliseconds at_most);

  std::uint64_t sent() const;
  std::uint64_t confirmed() const;
  std::string waiting_for() const;  // "the replay", "credit from the replay"

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How many transitions of a shape fit into one message, 256 at most; 0: none.
std::uint32_t TransitionsInMessage(const TransitionShape& shape);

}  // namespace ronda::dds
