#include "bench/decision_figures.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>
#include <vector>

#include "actor/actor.h"
#include "bench/rounds.h"
#include "common/environments/patrol_environment.h"
#include "common/policies/q_policy.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"

namespace ronda::bench {
namespace {

/// Takes every transition and gives the weights once.
class Ports final : public TransitionSink, public WeightSource {
 public:
  explicit Ports(WeightSnapshot snapshot) : snapshot_(std::move(snapshot)) {}
  PushResult Push(const Transition&) override { return PushResult::kAccepted; }
  void Poll() override {}
  void Wait(std::chrono::milliseconds) override {}
  const WeightSnapshot* Newest() override {
    return std::exchange(fresh_, false) ? &snapshot_ : nullptr;
  }

 private:
  WeightSnapshot snapshot_;
  bool fresh_ = true;
};

struct Saved {
  std::vector<float> observation;
  std::vector<std::uint8_t> legal;
};

/// Decisions some way apart, as the policy meets them.
std::vector<Saved> SaveDecisions(PatrolEnvironment environment, QPolicy& policy) {
  environment.Reset(Rng(3));
  std::vector<Saved> saved;
  for (int i = 0; saved.size() < 256; ++i) {
    const Decision& decision = environment.decision();
    if (i % 7 == 0)
      saved.push_back({{decision.observation.begin(), decision.observation.end()},
                       {decision.legal_actions.begin(), decision.legal_actions.end()}});
    const int action = policy.Act(decision.observation, decision.legal_actions);
    if (environment.Step(action).state != EpisodeState::kRunning) environment.Reset(Rng(4));
  }
  return saved;
}

}  // namespace

void PrintDecisionFigures(const std::string& map, int robots, double slice_s, int rounds) {
  const PatrolGraph graph =
      LoadMap(map, RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  const PatrolEnvironmentOptions options{.agents = robots,
                                         .closed_walk_m = ClosedWalkOf(graph, paths).length_m};
  PatrolEnvironment environment(graph, paths, options);
  const NetworkSpec spec{.kind = NetworkSpec::Kind::kCandidateScorer,
                         .observation_size = environment.encoder().observation_size(),
                         .num_actions = environment.encoder().num_actions(),
                         .features = environment.encoder().features_per_candidate(),
                         .hidden = {64, 64},
                         .schema = "bench"};
  const QNetwork<float> network(spec);
  WeightSnapshot snapshot{.version = 1,
                          .architecture_hash = network.architecture_hash(),
                          .values = std::vector<float>(network.parameter_count())};
  Rng rng(2);
  network.Initialise(rng, snapshot.values);
  QPolicy policy(spec);
  if (policy.Load(snapshot) != LoadResult::kLoaded) std::abort();
  const std::vector<Saved> saved = SaveDecisions(environment, policy);
  double candidates = 0.0;
  for (const Saved& one : saved)
    candidates += static_cast<double>(std::count(one.legal.begin(), one.legal.end(), 1)) /
                  static_cast<double>(saved.size());

  std::size_t turn = 0;
  long sum = 0;
  environment.Reset(Rng(5));
  PatrolEnvironment actors_own(graph, paths, options);
  Ports ports(snapshot);
  QPolicy actors_policy(spec);
  Actor actor(actors_own, actors_policy, ports, ports, {.exploration = {.start = 0.0, .end = 0.0}});
  const auto rates = MeasureInTurn(slice_s, rounds,
                                   {[&] {
                                      const Saved& one = saved[turn++ % saved.size()];
                                      sum += policy.Act(one.observation, one.legal);
                                    },
                                    [&] {
                                      const Decision& decision = environment.decision();
                                      const int action =
                                          policy.Act(decision.observation, decision.legal_actions);
                                      if (environment.Step(action).state != EpisodeState::kRunning)
                                        environment.Reset(Rng(6));
                                    },
                                    [&] { sum += actor.Step(); }});
  if (sum < 0) std::abort();  // the actions are used
  fmt::print("scorer 26-64-64-1 on {}, V = {}, N = {}, {:.2f} candidates a decision\n", map,
             graph.vertex_count(), robots, candidates);
  const char* const names[] = {"network alone, then argmax", "world, encoder and network",
                               "Actor::Step, whole (to an in-memory sink)"};
  for (std::size_t i = 0; i < rates.size(); ++i)
    fmt::print("  {:<44} {:>9.0f} decisions/s  {:6.3f} us\n", names[i], Median(rates[i]),
               1e6 / Median(rates[i]));
}

}  // namespace ronda::bench
