#pragma once
// An actor: acts in its environment with the newest weights that it has, and sends what comes of
// it.
//
// `Step` makes one decision and returns 1, or 0 where the sink throttles: completed transitions
// wait in an outbox, and the environment stands still until it is empty. Weights are loaded between
// two decisions. Until the first have come the actor acts at random. Never blocks.
// Thread-compatible.
#include <cstdint>

#include "actor/exploration.h"
#include "actor/n_step_adder.h"
#include "common/rl/environment.h"
#include "common/rl/policy.h"
#include "common/rl/ports.h"

namespace ronda {

struct ActorOptions {
  std::uint64_t seed = 1;
  std::uint32_t index = 0;
  std::uint32_t actors = 1;
  std::uint64_t incarnation = 0;  // a restarted actor does not repeat its predecessor's episodes
  int n_steps = 1;
  ExplorationConfig exploration;
};

class Actor {
 public:
  Actor(Environment& environment, Policy& policy, TransitionSink& sink, WeightSource& weights,
        const ActorOptions& options);

  int Step();
  void set_progress(double progress) { progress_ = progress; }

  std::uint64_t decisions() const { return decisions_; }
  std::uint64_t episodes() const { return episodes_; }
  std::uint64_t weights_version() const { return weights_version_; }
  std::uint64_t weights_refused() const { return weights_refused_; }
  double epsilon() const;

 private:
  bool EmptyOutbox();
  void LoadNewestWeights();
  int ChooseAction(const Decision& decision);
  void BeginEpisode();

  Environment& environment_;
  Policy& policy_;
  TransitionSink& sink_;
  WeightSource& weights_;
  ActorOptions options_;
  Rng rng_;
  NStepAdder adder_;
  double progress_ = 0.0;
  std::uint64_t decisions_ = 0;
  std::uint64_t episodes_ = 0;
  std::uint64_t weights_version_ = 0;  // 0: none yet
  std::uint64_t weights_refused_ = 0;
};

}  // namespace ronda
