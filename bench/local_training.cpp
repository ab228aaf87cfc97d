// Trains a policy in one thread with the actor's, the replay's and the learner's own code and no
// transport, and prints how AGI falls: what an algorithm can do before a cluster is asked for it.
//
//   build/release/bin/local_training [MAP] [AGENTS] [DECISIONS] [SEED] [KEY=VALUE …]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "actor/actor.h"
#include "actor/actor_config.h"
#include "common/evaluation/protocol.h"
#include "common/policies/network_config.h"
#include "common/policies/q_policy.h"
#include "common/team/policy_strategy.h"
#include "deploy/train_setup.h"
#include "learner/learner.h"
#include "learner/learner_config.h"
#include "replay/replay_config.h"

namespace ronda {
namespace {

/// All ports at once: one actor's sink, the learner's source, and the weights between them.
class Ports final : public TransitionSink,
                    public BatchSource,
                    public PrioritySink,
                    public WeightSink,
                    public WeightSource {
 public:
  Ports(ReplayServer& replay, const RunConfig& run) : replay_(replay), batch_size_(run.batch_size) {
    batch_.shape = run.shape;
    batch_.replay_incarnation = 1;
    replay_.Insert(batch_);
  }

  PushResult Push(const Transition& transition) override {
    batch_.Append(transition);
    replay_.Insert(batch_);
    batch_.first_sequence += 1;
    batch_.Clear();
    return PushResult::kAccepted;
  }
  void Poll() override {}
  void Wait(std::chrono::milliseconds) override {}
  const SampledBatch* Next(std::chrono::milliseconds) override {
    replay_.Request({.learner_incarnation = 1,
                     .first_id = next_id_,
                     .end_id = next_id_ + 1,
                     .batch_size = batch_size_});
    const SampledBatch* batch = replay_.NextBatch();
    if (batch != nullptr) ++next_id_;
    return batch;
  }
  void Push(const PriorityUpdate& update) override { replay_.Reprioritise(update); }
  void Publish(const WeightSnapshot& snapshot) override {
    snapshot_ = snapshot;
    fresh_ = true;
  }
  const WeightSnapshot* Newest() override {
    return std::exchange(fresh_, false) ? &snapshot_ : nullptr;
  }
  const WeightSnapshot& snapshot() const { return snapshot_; }

 private:
  ReplayServer& replay_;
  std::uint32_t batch_size_;
  TransitionBatch batch_;
  std::uint64_t next_id_ = 0;
  WeightSnapshot snapshot_;
  bool fresh_ = false;
};

double Agi(const PolicyFile& policy, const StrategyContext& context, int agents, int episodes) {
  const EvaluationOptions options{.episodes = episodes, .seed = 1, .agents = agents};
  const auto result = Evaluate(
      context, [&] { return MakePolicyStrategy(policy, context); }, options, nullptr);
  return MeanWithInterval(result->agi_s()).mean;
}

int Run(int argc, char** argv) {
  TrainArguments arguments;
  arguments.map = argc > 1 ? argv[1] : "cumberland";
  arguments.agents = argc > 2 ? std::atoi(argv[2]) : 10;
  arguments.decisions = argc > 3 ? std::atoll(argv[3]) : 300'000;
  arguments.seed = argc > 4 ? std::atoll(argv[4]) : 1;
  arguments.settings.assign(argv + std::min(argc, 5), argv + argc);
  const TrainSetup setup(arguments, std::nullopt);
  const RunConfig& run = setup.run();
  const StrategyContext& context = setup.context();
  const std::uint64_t budget = run.budget_decisions;
  Config config = Config::FromString(setup.config().Resolved(), "resolved");
  const LearnerConfig learner_config = ReadLearnerConfig(config, run);
  const ReplayServerConfig replay_config = ReadReplayConfig(config, run);
  ActorConfig actor_config = setup.actor();
  actor_config.environment.closed_walk_m = context.closed_walk->length_m;

  PatrolEnvironment environment(*context.graph, *context.paths, actor_config.environment);
  QPolicy policy(learner_config.dqn.network);
  ReplayServer replay(replay_config, 1, SplitSeed(run.seed, 7));
  Dqn dqn(learner_config.dqn);
  Ports ports(replay, run);
  Actor actor(
      environment, policy, ports, ports,
      {.seed = run.seed, .n_step = actor_config.n_steps, .exploration = actor_config.exploration});
  Learner learner(dqn, ports, ports, ports, {.incarnation = 1});
  PolicyFile file = PolicyOf(run);

  const auto began = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point clock{};
  for (std::uint64_t decision = 1; decision <= budget; ++decision) {
    const double progress = static_cast<double>(decision) / static_cast<double>(budget);
    actor.set_progress(progress);
    dqn.set_progress(progress);
    actor.Step();
    clock += std::chrono::microseconds(50);
    while (learner.Step(clock, std::chrono::milliseconds(0)) > 0) {
    }
    if (decision % (budget / 20) == 0) {
      const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
      const auto weights = dqn.parameters();
      file.weights.assign(weights.begin(), weights.end());
      fmt::print(
          "{:9} decisions {:8} updates {:7.1f} s  eps {:.3f}  loss {:.4f}  Q {:.3f}  AGI {:.3f} "
          "s\n",
          decision, dqn.updates(), wall.count(), actor.epsilon(), learner.last_update().loss,
          learner.last_update().mean_q,
          Agi(file, context, run.agents, decision == budget ? 20 : 5));
      std::fflush(stdout);
    }
  }
  return 0;
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  try {
    return ronda::Run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "local_training: {}\n", error.what());
    return 1;
  }
}
