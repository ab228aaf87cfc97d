#pragma once
// The replay's channels: experience, requests and priorities in; status and mini-batches out.
//
// Take… gives the next message that decodes, if there is one; what does not is counted and put into
// words once for each sender. Send… never waits for a reader; false: not sent (a mini-batch is then
// asked for again). Thread-compatible. The participant must outlive it.
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "common/dds/participant.h"
#include "common/rl/messages.h"

namespace ronda::dds {

class ReplayEndpoint {
 public:
  explicit ReplayEndpoint(Participant& participant);
  ~ReplayEndpoint();

  [[nodiscard]] bool TakeBatch(TransitionBatch& batch);
  [[nodiscard]] bool TakeRequest(SampleRequest& request);
  [[nodiscard]] bool TakePriorities(PriorityUpdate& update);
  bool SendStatus(const ReplayStatus& status);
  bool SendBatch(const SampledBatch& batch);
  /// Returns when a message has come, or after that time.
  void Wait(std::chrono::milliseconds at_most);
  /// Waits until every reader that is there has the last status.
  void Flush(std::chrono::milliseconds at_most);

  std::uint64_t messages_refused() const;
  std::vector<std::string> TakeRefusals();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
