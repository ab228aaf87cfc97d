#pragma once
// The picture of a healthy run, for tests that show one: replay, learner and some actors.
#include <cstdint>
#include <string>

#include "deploy/run_status.h"

namespace ronda {

inline ProcessStatus ExampleProcess(const std::string& role, std::uint32_t index = 0) {
  ProcessStatus process;
  process.role = role;
  process.index = index;
  process.pid = 4100 + index + (role == "actor" ? 2 : role == "learner" ? 1 : 0);
  process.state = "running";
  if (role == "actor") {
    process.rates_per_s = {{"decisions", 5250.0}};
    process.lag_versions = 2.0;
  }
  if (role == "learner") process.rates_per_s = {{"updates", 310.0}, {"weights", 3.1}};
  if (role == "replay") process.rates_per_s = {{"stored", 20'950.0}, {"sampled", 79'360.0}};
  process.silent_s = 0.3;
  return process;
}

inline RunStatus ExampleRunStatus(std::uint32_t actors = 4) {
  RunStatus status;
  status.map = "cumberland";
  status.agents = 5;
  status.algorithm = "dqn";
  status.state = "running";
  status.launcher_pid = 4099;
  status.domain = 17;
  status.written_unix_s = 1'700'000'000.0;  // 22:13:20 UTC
  status.progress = 0.42;
  status.training_s = 150.0;
  status.left_s = 207.0;
  status.updates = 46'500;
  status.decisions_per_s = 21'000.0;
  status.updates_per_s = 310.0;
  status.replay_size = 100'000;
  status.replay_capacity = 1'000'000;
  status.totals.decisions = 3'150'000;
  status.totals.in_flight = 640;
  status.totals.weights_version = 465;
  status.actors_wanted = static_cast<int>(actors);
  for (const double agi_s : {31.2, 24.9, 19.1, 16.0, 14.4, 13.8, 13.3, 13.6, 12.92, 12.95}) {
    status.curve.push_back({15.0 * static_cast<double>(status.curve.size() + 1), agi_s});
  }
  status.best_agi_s = 12.92;
  status.best_classical = "gei:0.5";
  status.best_classical_agi_s = 13.74;
  status.lower_bound_agi_s = 9.97;
  status.processes = {ExampleProcess("replay"), ExampleProcess("learner")};
  for (std::uint32_t i = 0; i < actors; ++i) {
    status.processes.push_back(ExampleProcess("actor", i));
  }
  status.channels = {
      {"experience", "actors", "replay", 49'218, 812'000'000, 328.0, 5'400'000.0, ""},
      {"batches", "replay", "learner", 46'512, 1'890'000'000, 310.0, 12.6e6, ""},
      {"priorities", "learner", "replay", 46'500, 24'000'000, 310.0, 158'720.0, ""},
      {"weights", "learner", "actors", 465, 62'000'000, 3.1, 412'000.0, ""},
      {"control", "ronda", "all", 1500, 96'000, 10.0, 640.0, ""}};
  for (int i = 0; i < 6; ++i) {
    status.events.push_back({status.written_unix_s - 60.0 + 10.0 * i,
                             "policy 1" + std::to_string(i) + " judged, the best so far"});
  }
  return status;
}

/// A run in trouble: an actor is dead, another has died before, the replay makes actors wait.
inline RunStatus TroubledRunStatus(std::uint32_t actors = 4) {
  RunStatus status = ExampleRunStatus(actors);
  ProcessStatus& dead = status.processes.at(1 + actors);
  dead.pid = 0;
  dead.state = "dead, starting again in 1.2 s";
  dead.rates_per_s.clear();
  dead.lag_versions.reset();
  dead.restarts = 3;
  dead.last_error = "actor " + std::to_string(dead.index) + " was killed by signal 9";
  ProcessStatus& risen = status.processes.at(2);
  risen.restarts = 1;
  risen.last_error = "exit status 4: no replay answers";
  status.channels[0].waiting = "2 actors wait for room in the replay";
  status.problems = {"actor " + std::to_string(dead.index) + " is dead and starts again in 1.2 s"};
  status.events.push_back({status.written_unix_s - 1.0, dead.last_error});
  return status;
}

}  // namespace ronda
