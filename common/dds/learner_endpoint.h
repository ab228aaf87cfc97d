#pragma once
// The learner's way to the replay: asks for mini-batches ahead, takes them in, sends priorities
// back.
//
// Keeps `outstanding` mini-batches asked for, and asks on when half of them have come. Requests and
// mini-batches may be lost: what has not come within `request_timeout` is given up and new ones are
// asked for; a request is repeated while nothing comes, so a restarted replay gets it. Contract as
// rl/ports.h. Thread-compatible. The participant must outlive it.
#include <memory>
#include <string>
#include <vector>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

struct LearnerEndpointOptions {
  std::uint64_t learner_incarnation = 0;
  std::uint32_t batch_size = 128;
  int outstanding = 8;
  std::chrono::milliseconds request_timeout{2000};
};

class LearnerEndpoint final : public BatchSource, public PrioritySink {
 public:
  LearnerEndpoint(Participant& participant, const LearnerEndpointOptions& options);
  ~LearnerEndpoint() override;

  const SampledBatch* Next(std::chrono::milliseconds at_most) override;
  void Push(const PriorityUpdate& update) override;
  std::uint64_t messages_refused() const;
  std::vector<std::string> TakeRefusals();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
