// patrol MAP POLICY: four robots patrol a map for an hour by a trained policy, at 1 m/s. They are a
// queue of arrivals here; real ones would report theirs by radio.
#include <cstdio>
#include <queue>

#include "common/team/patrol_team.h"
#include "common/world/graph_file.h"

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: patrol MAP POLICY");
  const auto map = ronda::ReadGraphFile(argv[1], ronda::EdgeLengthSource::kEuclidean, nullptr);
  ronda::PatrolTeam team(map, argv[2], {.speeds_mps = {1, 1, 1, 1}, .starts = {0, 1, 2, 3}});
  const auto later = [](const auto& a, const auto& b) { return a.time_s > b.time_s; };
  std::priority_queue<ronda::RobotReport, std::vector<ronda::RobotReport>, decltype(later)> reports;
  for (int robot = 0; robot < 4; ++robot) reports.push({.robot = robot, .vertex = robot});
  int visits = 0;
  for (; reports.top().time_s < 3600.0; ++visits) {
    ronda::RobotReport report = reports.top();
    reports.pop();
    const int next = team.Decide(report);  // at report.vertex now; where to?
    report.time_s += map.edge_length_m(report.vertex, next) / 1.0;
    report.vertex = next;
    reports.push(report);
  }
  std::printf("%d visits, AGI %.2f s\n", visits, team.world().average_graph_idleness_s());
} catch (const std::exception& error) {
  std::fprintf(stderr, "patrol: %s\n", error.what());
  return 1;
}
