// ronda-learner: takes mini-batches from the replay, improves the policy, and publishes its
// weights.
#include <unistd.h>

#include <algorithm>

#include "common/dds/control_reader.h"
#include "common/dds/learner_endpoint.h"
#include "common/dds/participant.h"
#include "common/dds/report_writer.h"
#include "common/dds/weights_writer.h"
#include "common/nn/kernel.h"
#include "common/policies/network_config.h"
#include "common/policies/policy_file.h"
#include "common/run/every.h"
#include "common/run/log.h"
#include "common/run/process.h"
#include "common/run/role_options.h"
#include "learner/checkpoint.h"
#include "learner/learner.h"
#include "learner/learner_config.h"

namespace ronda {
namespace {

using std::chrono::milliseconds;

/// Restores the newest checkpoint, where there is one; returns the version of its weights.
std::uint64_t Restore(Dqn& dqn, const std::filesystem::path& checkpoints) {
  std::string note;
  const auto checkpoint = ReadLearnerCheckpoint(checkpoints, note);
  if (!note.empty()) LogWarning("the previous checkpoint is used: {}", note);
  if (!checkpoint) return 0;
  dqn.Load(checkpoint->algorithm);
  LogInfo("goes on from update {}", dqn.updates());
  return checkpoint->weights_version;
}

void Save(const Dqn& dqn, const Learner& learner, const RunConfig& run,
          const std::filesystem::path& checkpoints) {
  WriteLearnerCheckpoint(checkpoints,
                         {.algorithm = dqn.Save(), .weights_version = learner.weights_version()});
  PolicyFile policy = PolicyOf(run);
  policy.version = learner.weights_version();
  policy.updates = dqn.updates();
  const auto weights = dqn.parameters();
  policy.weights.assign(weights.begin(), weights.end());
  WritePolicyFile(checkpoints / "latest.ronda", policy);
}

ProcessReport Report(const RoleOptions& options, const Dqn& dqn, const Learner& learner,
                     const dds::LearnerEndpoint& batches, bool waiting) {
  const UpdateStats& last = learner.last_update();
  return {.role = "learner",
          .index = 0,
          .incarnation = options.incarnation,
          .pid = getpid(),
          .state = waiting ? "waiting for mini-batches" : "running",
          .metrics = {{"updates", static_cast<double>(dqn.updates())},
                      {"weights_version", static_cast<double>(learner.weights_version())},
                      {"policy_lag_versions", learner.policy_lag_versions()},
                      {"messages_refused", static_cast<double>(batches.messages_refused())},
                      {"loss", last.loss},
                      {"mean_q", last.mean_q},
                      {"gradient_norm", last.gradient_norm}}};
}

int Body(int argc, char** argv, std::stop_token stop) {
  const RoleOptions options = ParseRoleOptions(
      "learner", "The learner of a run: improves the policy, publishes weights.", argc, argv);
  StartLog("learner");
  if (options.end_with_parent) EndWithParent();
  const Kernel kernel = KernelInUse();
  Config file = Config::FromFile(options.config_file);
  const RunConfig run = ReadRunConfig(file);
  const LearnerConfig config = ReadLearnerConfig(file, run);
  const auto checkpoints = options.run_folder / "checkpoints";
  Dqn dqn(config.dqn);
  const std::uint64_t restored_version = Restore(dqn, checkpoints);

  dds::Participant participant({.domain = options.domain,
                                .run_id = options.run_id,
                                .name = "learner",
                                .socket_buffer_bytes = run.socket_buffer_bytes});
  LogInfo("domain {}, {}, kernel {}", options.domain, participant.socket_buffer_report(),
          NameOf(kernel));
  dds::LearnerEndpoint batches(participant, {.learner_incarnation = options.incarnation,
                                             .batch_size = run.batch_size,
                                             .outstanding = config.outstanding});
  dds::WeightsWriter weights(participant);
  dds::ControlReader control(participant);
  dds::ReportWriter reports(participant);
  Learner learner(dqn, batches, batches, weights,
                  {.incarnation = options.incarnation,
                   .weights_version = std::max(restored_version, options.weights_version),
                   .publish_every = config.publish_every,
                   .send_priorities = config.send_priorities});
  Every report_due(milliseconds(200));
  Every checkpoint_due(config.checkpoint_every);
  while (!stop.stop_requested()) {
    if (const RunControl* news = control.Newest()) dqn.set_progress(news->progress);
    const int updates = learner.Step(std::chrono::steady_clock::now(), milliseconds(20));
    const auto now = std::chrono::steady_clock::now();
    if (report_due.Due(now)) reports.Send(Report(options, dqn, learner, batches, updates == 0));
    for (const auto& refusal : batches.TakeRefusals()) LogWarning("{}", refusal);
    if (checkpoint_due.Due(now)) Save(dqn, learner, run, checkpoints);
  }
  learner.Publish(std::chrono::steady_clock::now());
  Save(dqn, learner, run, checkpoints);
  reports.Send(Report(options, dqn, learner, batches, false));
  reports.Flush(milliseconds(100));
  LogInfo("stopped after update {}, checkpoint written", dqn.updates());
  return 0;
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  return ronda::RunProcess("ronda-learner", [&](std::stop_token stop) {
    return ronda::Body(argc, argv, std::move(stop));
  });
}
