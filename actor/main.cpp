// ronda-actor: patrols with the newest weights and sends what it learns from to the replay.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "actor/actor.h"
#include "actor/actor_config.h"
#include "common/dds/control_reader.h"
#include "common/dds/experience_writer.h"
#include "common/dds/participant.h"
#include "common/dds/report_writer.h"
#include "common/dds/weights_reader.h"
#include "common/nn/kernel.h"
#include "common/policies/network_config.h"
#include "common/policies/q_policy.h"
#include "common/run/every.h"
#include "common/run/log.h"
#include "common/run/paths.h"
#include "common/run/process.h"
#include "common/run/role_options.h"
#include "common/world/closed_walk.h"
#include "common/world/graph_file.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;

/// A replay that was killed is back by then. The launcher waits for less at the end of a run.
constexpr milliseconds kLongestDrain{10'000};
constexpr milliseconds kOrphanDrain{500};  // the launcher is gone, and the replay goes too

ProcessReport Report(const RoleOptions& options, const Actor& actor,
                     const dds::ExperienceWriter& sink, const dds::WeightsReader& weights,
                     bool throttled) {
  return {.role = "actor",
          .index = options.index,
          .incarnation = options.incarnation,
          .pid = getpid(),
          .state = throttled ? "waiting for " + sink.waiting_for() : "running",
          .metrics = {{"decisions", static_cast<double>(actor.counters().decisions)},
                      {"sent", static_cast<double>(sink.sent())},
                      {"confirmed", static_cast<double>(sink.confirmed())},
                      {"weights_version", static_cast<double>(actor.counters().weights_version)},
                      {"messages_refused", static_cast<double>(weights.messages_refused())},
                      {"epsilon", actor.epsilon()}}};
}

int Body(int argc, char** argv, std::stop_token stop) {
  const RoleOptions options =
      ParseRoleOptions("actor", "An actor of a run: patrols and sends transitions.", argc, argv);
  StartLog(fmt::format("actor-{}", options.index));
  const pid_t parent = ::getppid();
  if (options.end_with_parent) EndWithParent();
  const Kernel kernel = KernelInUse();
  Config file = Config::FromFile(options.config_file);
  const RunConfig run = ReadRunConfig(file);
  ActorConfig config = ReadActorConfig(file, run);
  const PatrolGraph graph =
      WithPriorities(LoadMap(run.map, MapsFolder(), ParseEdgeLengthSource(run.length), nullptr),
                     config.environment.conditions);
  const ShortestPaths paths(graph);
  config.environment.closed_walk_m = ClosedWalkOf(graph, paths).length_m;
  PatrolEnvironment environment(graph, paths, config.environment);
  QPolicy policy(NetworkOf(run));

  dds::Participant participant({.domain = options.domain,
                                .run_id = options.run_id,
                                .name = fmt::format("actor-{}", options.index),
                                .socket_buffer_bytes = run.socket_buffer_bytes});
  LogInfo("domain {}, {}, kernel {}", options.domain, participant.socket_buffer_report(),
          NameOf(kernel));
  dds::ExperienceWriter sink(participant, {.actor = options.index,
                                           .incarnation = options.incarnation,
                                           .shape = run.shape,
                                           .batch_size = config.batch_size,
                                           .max_age = config.max_age});
  dds::WeightsReader weights(participant, policy.architecture_hash());
  dds::ControlReader control(participant);
  dds::ReportWriter reports(participant);
  Actor actor(environment, policy, sink, weights,
              {.seed = run.seed,
               .index = static_cast<int>(options.index),
               .actors = std::max(run.actors, static_cast<int>(options.index) + 1),
               .n_step = config.n_steps,
               .exploration = config.exploration});
  Every report_due(milliseconds(200));
  while (!stop.stop_requested()) {
    if (const RunControl* news = control.Newest()) {
      actor.set_progress(news->progress);
      actor.set_actors(static_cast<int>(news->actors));
    }
    constexpr int kInARow = 100;
    int decisions = 0;
    while (decisions < kInARow && actor.Step() > 0) ++decisions;
    const bool throttled = decisions == 0;
    if (report_due.Due(std::chrono::steady_clock::now())) {
      reports.Send(Report(options, actor, sink, weights, throttled));
    }
    for (const auto& refusal : weights.TakeRefusals()) LogWarning("{}", refusal);
    if (throttled) sink.Wait(milliseconds(20));
  }
  reports.Send(Report(options, actor, sink, weights, false));  // drained or not, it is counted
  const bool orphan = options.end_with_parent && ::getppid() != parent;
  const bool confirmed = sink.Drain(orphan ? kOrphanDrain : kLongestDrain);
  reports.Send(Report(options, actor, sink, weights, false));
  reports.Flush(milliseconds(100));
  if (!confirmed)
    LogWarning("stopped before everything was confirmed: {} of {} sent", sink.confirmed(),
               sink.sent());
  LogInfo("stopped after {} decisions, {} transitions sent", actor.counters().decisions,
          sink.sent());
  return 0;
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  return ronda::RunProcess("ronda-actor", [&](std::stop_token stop) {
    return ronda::Body(argc, argv, std::move(stop));
  });
}
