#pragma once
// The newest weights of this run's architecture: others, torn, not finite or older ones are refused
// and counted.
//
// Versions only grow, over restarts of the learner too. Thread-compatible. The participant must
// outlive it.
#include <memory>
#include <string>
#include <vector>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class WeightsReader final : public WeightSource {
 public:
  WeightsReader(Participant& participant, std::uint64_t architecture_hash);
  ~WeightsReader() override;
  const WeightSnapshot* Newest() override;
  void Wait(std::chrono::milliseconds at_most);  // until something has come

  std::uint64_t messages_refused() const;
  std::vector<std::string> TakeRefusals();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
