// ronda-replay: stores the actors' transitions and pushes mini-batches to the learner.
#include <unistd.h>

#include "common/dds/control_reader.h"
#include "common/dds/participant.h"
#include "common/dds/replay_endpoint.h"
#include "common/dds/report_writer.h"
#include "common/run/every.h"
#include "common/run/log.h"
#include "common/run/process.h"
#include "common/run/role_options.h"
#include "replay/replay_config.h"
#include "replay/replay_server.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;

ProcessReport Report(const RoleOptions& options, const ReplayStatus& status) {
  const char* state = status.samples_wait != 0   ? "waiting for transitions"
                      : status.inserts_wait != 0 ? "waiting for the learner"
                                                 : "running";
  return {.role = "replay",
          .index = 0,
          .incarnation = options.incarnation,
          .pid = getpid(),
          .state = state,
          .metrics = {{"size", static_cast<double>(status.size)},
                      {"stored", static_cast<double>(status.stored)},
                      {"sampled", static_cast<double>(status.sampled)}}};
}

/// Takes what has come and sends what is asked for; returns how many messages that were.
int Serve(ReplayServer& server, dds::ReplayEndpoint& endpoint) {
  constexpr int kMost = 64;  // then it is time to say what is stored
  int messages = 0;
  TransitionBatch transitions;
  while (messages < kMost && endpoint.TakeBatch(transitions)) {
    server.Insert(transitions);
    ++messages;
  }
  SampleRequest request;
  while (endpoint.TakeRequest(request)) {
    server.Request(request);
    ++messages;
  }
  PriorityUpdate priorities;
  while (endpoint.TakePriorities(priorities)) {
    server.Reprioritise(priorities);
    ++messages;
  }
  while (const SampledBatch* batch = server.NextBatch()) {
    ++messages;
    if (!endpoint.SendBatch(*batch)) break;  // the learner asks again
  }
  return messages;
}

int Body(int argc, char** argv, std::stop_token stop) {
  const RoleOptions options = ParseRoleOptions(
      "replay", "The replay of a run: stores transitions, gives mini-batches.", argc, argv);
  StartLog("replay");
  if (options.end_with_parent) EndWithParent();
  Config file = Config::FromFile(options.config_file);
  const RunConfig run = ReadRunConfig(file);
  ReplayServer server(ReadReplayConfig(file, run), options.incarnation,
                      SplitSeed(run.seed, options.incarnation));
  LogInfo("room for {} MB of transitions", server.bytes() / 1'000'000);

  dds::Participant participant({.domain = options.domain,
                                .run_id = options.run_id,
                                .name = "replay",
                                .socket_buffer_bytes = run.socket_buffer_bytes});
  LogInfo("domain {}, {}", options.domain, participant.socket_buffer_report());
  dds::ReplayEndpoint endpoint(participant);
  dds::ControlReader control(participant);
  dds::ReportWriter reports(participant);
  const auto status = [&] {
    ReplayStatus now = server.Status();
    now.messages_refused += endpoint.messages_refused();
    return now;
  };
  Every status_due(milliseconds(5));
  Every report_due(milliseconds(200));
  while (!stop.stop_requested()) {
    if (const RunControl* news = control.Newest()) server.set_actors(news->actors);
    const int messages = Serve(server, endpoint);
    const auto now = std::chrono::steady_clock::now();
    if (status_due.Due(now)) endpoint.SendStatus(status());
    if (report_due.Due(now)) {
      reports.Send(Report(options, status()));
      for (const auto& refusal : server.TakeRefusals()) LogWarning("{}", refusal);
      for (const auto& refusal : endpoint.TakeRefusals()) LogWarning("{}", refusal);
    }
    if (messages == 0) endpoint.Wait(milliseconds(5));
  }
  Serve(server, endpoint);
  endpoint.SendStatus(status());
  reports.Send(Report(options, status()));
  endpoint.Flush(milliseconds(100));
  reports.Flush(milliseconds(100));
  LogInfo("stopped with {} transitions", status().size);
  return 0;
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  return ronda::RunProcess("ronda-replay", [&](std::stop_token stop) {
    return ronda::Body(argc, argv, std::move(stop));
  });
}
