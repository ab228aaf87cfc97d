#pragma once
// Weights to actors and evaluators: the newest replaces what came before, and late joiners get it.
//
// Never waits for a reader. Thread-compatible. The participant must outlive it.
#include <memory>

#include "common/dds/participant.h"
#include "common/rl/ports.h"

namespace ronda::dds {

class WeightsWriter final : public WeightSink {
 public:
  explicit WeightsWriter(Participant& participant);
  ~WeightsWriter() override;
  void Publish(const WeightSnapshot& snapshot) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ronda::dds
