// Trains a policy in one thread with the actor's, the replay's and the learner's own code and no
// transport, and prints how AGI falls: what an algorithm can do before a cluster is asked for it.
//
//   build/release/bin/local_training [MAP] [AGENTS] [DECISIONS] [SEED] [KEY=VALUE …]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <deque>

#include "actor/actor.h"
#include "actor/actor_config.h"
#include "common/evaluation/policy_strategy.h"
#include "common/evaluation/protocol.h"
#include "common/policies/q_policy.h"
#include "common/run/paths.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"
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
  const std::string map = argc > 1 ? argv[1] : "cumberland";
  Config config;
  config.Set("run.agents=" + std::string(argc > 2 ? argv[2] : "10"));
  const auto budget = std::strtoull(argc > 3 ? argv[3] : "300000", nullptr, 10);
  config.Set("run.seed=" + std::string(argc > 4 ? argv[4] : "1"));
  for (int i = 5; i < argc; ++i) config.Set(argv[i]);

  const PatrolGraph graph = LoadMap(map, MapsFolder(), EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  const ClosedWalk walk = ClosedWalkOf(graph, paths);
  const StrategyContext context{.graph = &graph, .paths = &paths, .closed_walk = &walk};
  RunConfig run = ReadRunConfig(config);
  ActorConfig actor_config = ReadActorConfig(config, run);
  actor_config.environment.closed_walk_m = walk.length_m;
  const ObservationEncoder encoder(actor_config.environment.observation, graph, paths);
  run.shape = encoder.shape();
  run.features = encoder.features();
  run.schema = encoder.schema();
  const LearnerConfig learner_config = ReadLearnerConfig(config, run);
  const ReplayServerConfig replay_config = ReadReplayConfig(config, run);
  config.RejectUnknown();

  PatrolEnvironment environment(graph, paths, actor_config.environment);
  QPolicy policy(learner_config.dqn.network);
  ReplayServer replay(replay_config, 1, SplitSeed(run.seed, 7));
  Dqn dqn(learner_config.dqn);
  Ports ports(replay, run);
  Actor actor(
      environment, policy, ports, ports,
      {.seed = run.seed, .n_steps = actor_config.n_steps, .exploration = actor_config.exploration});
  Learner learner(dqn, ports, ports, ports, {.incarnation = 1});
  PolicyFile file;
  file.spec = learner_config.dqn.network;
  file.map = map;

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
