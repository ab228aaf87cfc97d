// How long an observation of candidates takes, against plain loops without tables in the same run.
//
//   encoder_bench [map, default cumberland] [robots, default 10] [seconds for each figure, default
//   1]
//
// Observes the robots' decisions of a random walk, each observation again and again over 256 saved
// worlds. Prints microseconds and ratios, and steps per second of the whole environment; asserts
// nothing.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "common/environments/patrol_environment.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"
#include "tests/unit/candidate_reference.h"

namespace {

using namespace ronda;

struct Moment {
  PatrolWorld world;
  int robot;
};

std::vector<Moment> Moments(const PatrolGraph& graph, int robots) {
  PatrolWorld world(graph, {.speeds_mps = std::vector<double>(robots, 1.0)});
  Rng rng(1);
  world.Reset(PatrolWorld::RandomStarts(graph, robots, rng), Rng(2));
  std::vector<Moment> moments;
  for (int i = 0; moments.size() < 256; ++i) {
    const auto arrival = world.NextArrival(std::numeric_limits<double>::infinity());
    if (i % 7 == 6 && i > 1000) moments.push_back({world, arrival->robot});
    const auto neighbours = graph.neighbours(arrival->vertex);
    const int next = neighbours[rng.Below(static_cast<std::uint32_t>(neighbours.size()))];
    world.Depart(arrival->robot, next);
  }
  return moments;
}

/// Microseconds a call, for the best of five rounds.
template <typename Call>
double Microseconds(double seconds, Call call) {
  double best_us = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 5; ++round) {
    const auto start = std::chrono::steady_clock::now();
    double elapsed_us = 0.0;
    long calls = 0;
    while (elapsed_us < 1e6 * seconds / 5) {
      for (int i = 0; i < 64; ++i) call();
      calls += 64;
      elapsed_us =
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
              .count();
    }
    best_us = std::min(best_us, elapsed_us / static_cast<double>(calls));
  }
  return best_us;
}

double EncodeTime_us(const PatrolGraph& graph, const ShortestPaths& paths,
                     const std::vector<Moment>& moments, ObservationScheme scheme, double seconds) {
  ObservationEncoder encoder(graph, paths, scheme);
  std::vector<float> observation(encoder.observation_size());
  std::vector<std::uint8_t> legal(encoder.num_actions());
  std::size_t i = 0;
  return Microseconds(seconds, [&] {
    const Moment& moment = moments[i++ % moments.size()];
    encoder.Encode(CompleteBelief(moment.world, moment.robot), observation, legal);
  });
}

double StepTime_us(const PatrolGraph& graph, const ShortestPaths& paths, int robots,
                   double seconds) {
  PatrolEnvironment environment(
      graph, paths, {.agents = robots, .closed_walk_m = ClosedWalkOf(graph, paths).length_m});
  Rng rng(3);
  environment.Reset(rng);
  return Microseconds(seconds, [&] {
    const int vertex = environment.world().target(environment.decision().agent);
    const auto degree = static_cast<std::uint32_t>(graph.degree(vertex));
    const auto outcome = environment.Step(static_cast<int>(rng.Below(degree)));
    if (outcome.state != EpisodeState::kRunning) environment.Reset(rng);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string map = argc > 1 ? argv[1] : "cumberland";
  const int robots = argc > 2 ? std::atoi(argv[2]) : 10;
  const double seconds = argc > 3 ? std::atof(argv[3]) : 1.0;
  const PatrolGraph graph =
      LoadMap(map, RONDA_SOURCE_DIR "/maps", EdgeLengthSource::kEuclidean, nullptr);
  const ShortestPaths paths(graph);
  const auto moments = Moments(graph, robots);
  double candidates = 0.0;
  for (const Moment& moment : moments) {
    candidates += graph.degree(moment.world.target(moment.robot));
  }
  candidates /= static_cast<double>(moments.size());

  const double encode_us =
      EncodeTime_us(graph, paths, moments, ObservationScheme::kCandidates, seconds);
  const double thesis_us =
      EncodeTime_us(graph, paths, moments, ObservationScheme::kThesis, seconds);
  double sum = 0.0;
  std::size_t i = 0;
  const double reference_us = Microseconds(seconds, [&] {
    const Moment& moment = moments[i++ % moments.size()];
    sum += ReferenceCandidateFeatures(moment.world, paths, moment.robot)[0][0];
  });
  const double step_us = StepTime_us(graph, paths, robots, seconds);

  fmt::print("{}, V = {}, N = {}, {:.2f} candidates a decision\n", map, graph.vertex_count(),
             robots, candidates);
  fmt::print("candidates   {:8.3f} us a decision  {:8.3f} us a candidate\n", encode_us,
             encode_us / candidates);
  fmt::print("plain loops  {:8.3f} us a decision  {:8.3f} us a candidate  (ratio {:.1f})\n",
             reference_us, reference_us / candidates, reference_us / encode_us);
  fmt::print("thesis       {:8.3f} us a decision\n", thesis_us);
  fmt::print("environment  {:8.3f} us a step, so {:.0f} decisions/s\n", step_us, 1e6 / step_us);
  return sum > 0.0 ? 0 : 1;
}
