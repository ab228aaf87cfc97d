#include "common/world/strategies/conscientious_reactive.h"

#include <cstddef>

#include "common/world/strategies/random_argmax.h"

namespace ronda {

std::vector<RobotStart> ConscientiousReactive::Begin(const PatrolGraph& graph,
                                                     std::span<const double> speeds_mps, Rng& rng) {
  own_visits_s_.assign(speeds_mps.size() * static_cast<std::size_t>(graph.vertex_count()), 0.0);
  return Strategy::Begin(graph, speeds_mps, rng);
}

int ConscientiousReactive::Decide(const PatrolWorld& world, const Arrival& arrival, Rng& rng) {
  const auto row = static_cast<std::size_t>(arrival.robot) *
                   static_cast<std::size_t>(world.graph().vertex_count());
  double* const own_visits_s = &own_visits_s_[row];  // (V)
  own_visits_s[arrival.vertex] = arrival.time_s;
  RandomArgmax choice(rng);
  for (const int neighbour : world.graph().neighbours(arrival.vertex)) {
    choice.Offer(neighbour, arrival.time_s - own_visits_s[neighbour]);
  }
  return choice.best();
}

}  // namespace ronda
