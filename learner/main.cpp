// ronda-learner: takes mini-batches from the replay, improves the policy, and publishes its
// weights.
#include <unistd.h>

#include <algorithm>

#include "common/base/error.h"
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
std::uint64_t Restore(Algorithm& algorithm, const std::filesystem::path& checkpoints) {
  std::string note;
  const auto checkpoint = ReadLearnerCheckpoint(checkpoints, note);
  if (!note.empty()) LogWarning("the previous checkpoint is used: {}", note);
  if (!checkpoint) return 0;
  algorithm.Load(checkpoint->algorithm);
  LogInfo("goes on from update {}", algorithm.updates());
  return checkpoint->weights_version;
}

void Save(const Algorithm& algorithm, const Learner& learner, const RunConfig& run,
          const std::filesystem::path& checkpoints) {
  WriteLearnerCheckpoint(
      checkpoints, {.algorithm = algorithm.Save(), .weights_version = learner.weights_version()});
  PolicyFile policy = PolicyOf(run);
  policy.version = learner.weights_version();
  policy.updates = algorithm.updates();
  const auto weights = algorithm.parameters();
  policy.weights.assign(weights.begin(), weights.end());
  WritePolicyFile(checkpoints / "latest.ronda", policy);
}

/// False where the disk takes no checkpoint; the former one stands then. Said when it begins.
bool TrySave(const Algorithm& algorithm, const Learner& learner, const RunConfig& run,
             const std::filesystem::path& checkpoints, bool saved_before) {
  try {
    Save(algorithm, learner, run, checkpoints);
    return true;
  } catch (const Error& error) {
    if (saved_before) LogWarning("no checkpoint, the former one stands: {}", error.what());
    return false;
  }
}

ProcessReport Report(const RoleOptions& options, const Algorithm& algorithm, const Learner& learner,
                     const dds::LearnerEndpoint& batches, bool waiting, bool saved) {
  const UpdateStats& last = learner.last_update();
  return {.role = "learner",
          .index = 0,
          .incarnation = options.incarnation,
          .pid = getpid(),
          .state = waiting ? "waiting for mini-batches" : "running",
          .metrics = {{"updates", static_cast<double>(algorithm.updates())},
                      {"weights_version", static_cast<double>(learner.weights_version())},
                      {"policy_lag_versions", learner.policy_lag_versions()},
                      {"messages_refused", static_cast<double>(batches.messages_refused())},
                      {"checkpoint_fails", saved ? 0.0 : 1.0},
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
  const auto algorithm = MakeAlgorithm(run, config);
  const std::uint64_t restored_version = Restore(*algorithm, checkpoints);

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
  Learner learner(*algorithm, batches, batches, weights,
                  {.incarnation = options.incarnation,
                   .weights_version = std::max(restored_version, options.weights_version),
                   .publish_every = config.publish_every,
                   .send_priorities = config.send_priorities});
  Every report_due(milliseconds(200));
  Every checkpoint_due(config.checkpoint_every);
  bool saved = true;
  while (!stop.stop_requested()) {
    if (const RunControl* news = control.Newest()) algorithm->set_progress(news->progress);
    const int updates = learner.Step(std::chrono::steady_clock::now(), milliseconds(20));
    const auto now = std::chrono::steady_clock::now();
    if (report_due.Due(now)) {
      reports.Send(Report(options, *algorithm, learner, batches, updates == 0, saved));
    }
    for (const auto& refusal : batches.TakeRefusals()) LogWarning("{}", refusal);
    if (checkpoint_due.Due(now)) saved = TrySave(*algorithm, learner, run, checkpoints, saved);
  }
  learner.Publish(std::chrono::steady_clock::now());
  saved = TrySave(*algorithm, learner, run, checkpoints, true);
  reports.Send(Report(options, *algorithm, learner, batches, false, saved));
  reports.Flush(milliseconds(100));
  LogInfo("stopped after update {}, {}", algorithm->updates(),
          saved ? "checkpoint written" : "no checkpoint could be written");
  return saved ? 0 : static_cast<int>(ExitCode::kCheckpoint);
}

}  // namespace
}  // namespace ronda

int main(int argc, char** argv) {
  return ronda::RunProcess("ronda-learner", [&](std::stop_token stop) {
    return ronda::Body(argc, argv, std::move(stop));
  });
}
