#include "deploy/training_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <thread>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/dds/control_writer.h"
#include "common/dds/participant.h"
#include "common/dds/report_reader.h"
#include "common/dds/status_reader.h"
#include "common/dds/weights_reader.h"
#include "common/policies/network_config.h"
#include "common/run/every.h"
#include "common/run/incarnation.h"
#include "common/run/metrics_log.h"
#include "common/run/paths.h"
#include "common/run/run_domain.h"
#include "deploy/cluster.h"
#include "deploy/find_policy.h"
#include "deploy/progress_line.h"
#include "deploy/summary.h"
#include "deploy/training_evaluator.h"
#include "deploy/transition_ledger.h"

namespace ronda {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::chrono::seconds kQuiet{2};             // then the line says who waits for what
constexpr std::chrono::seconds kLongestSilence{120};  // without any transition: the run ends
constexpr milliseconds kStopGrace{1300};              // twice, and some judging: all within 3 s
constexpr std::uint64_t kEvaluationSeed = 1'000'003;  // far from the seeds that are reported

double Seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

TrainingEvaluatorConfig EvaluatorConfig(const TrainSetup& setup, const RunFolder& folder) {
  TrainingEvaluatorConfig config;
  config.agents = setup.run().agents;
  config.speed_mps = setup.actor().environment.speed_mps;
  config.travel_noise = setup.actor().environment.travel_noise;
  config.episodes = setup.evaluation().episodes;
  config.step = setup.evaluation().step;
  config.seed = kEvaluationSeed + setup.run().seed;
  config.policy = PolicyOf(setup.run());
  config.checkpoints = folder.checkpoints();
  return config;
}

/// A session's parts and what they have reported so far.
class Session {
 public:
  Session(const TrainSetup& setup, const RunFolder& folder)
      : setup_(setup),
        folder_(folder),
        before_(ReadRunState(folder.path())),
        state_(before_),
        ledger_(before_.totals),
        run_id_(fmt::format("{}-{}", getpid(), NewIncarnation())),
        domain_(std::hash<std::string>{}(folder.path().string())),
        participant_({.domain = domain_.domain(),
                      .run_id = run_id_,
                      .name = "ronda",
                      .socket_buffer_bytes = setup.run().socket_buffer_bytes}),
        control_(participant_),
        reports_(participant_),
        statuses_(participant_),
        weights_(participant_, ArchitectureHash(NetworkOf(setup.run()))),
        evaluator_config_(EvaluatorConfig(setup, folder)),
        evaluator_(evaluator_config_, setup.context(), weights_, before_.best),
        metrics_(folder.metrics_file(), "ronda") {
    for (const Role role : {Role::kActor, Role::kReplay, Role::kLearner}) {
      state_.restarts.try_emplace(RoleName(role), 0);
    }
  }

  int Run(std::stop_token stop);

 private:
  void Listen();
  void TakeReport(const ProcessReport& report);
  std::optional<int> Supervise(Cluster& cluster, Clock::time_point now);
  std::string WhoWaits() const;
  /// The exit status of a run in which nothing moves any more.
  std::optional<int> CheckProgress(Clock::time_point now);
  void UpdateState(const Cluster& cluster, Clock::time_point now);
  void Show(Clock::time_point now);
  void LogMetrics();
  int End(Cluster& cluster, std::stop_token stop, std::optional<int> failure);
  void Summarise(std::stop_token stop, bool hurry);

  const TrainSetup& setup_;
  const RunFolder& folder_;
  const RunState before_;  // what former sessions left
  RunState state_;
  TransitionLedger ledger_;
  std::string run_id_;
  RunDomain domain_;
  dds::Participant participant_;
  dds::ControlWriter control_;
  dds::ReportReader reports_;
  dds::StatusReader statuses_;
  dds::WeightsReader weights_;  // the evaluator's thread uses it
  TrainingEvaluatorConfig evaluator_config_;
  TrainingEvaluator evaluator_;
  MetricsLog metrics_;
  ProgressLine line_;

  Clock::time_point began_ = Clock::now();
  std::optional<Clock::time_point> first_transition_;
  ReplayStatus status_;
  double policy_lag_versions_ = 0.0;
  Clock::time_point last_transition_ = Clock::now();
  std::map<std::string, std::string> states_;  // what each process said last of itself
  std::optional<double> agi_s_;
  // For rates: what the last line showed.
  Clock::time_point shown_ = Clock::now();
  std::uint64_t shown_decisions_ = before_.totals.decisions;
  std::uint64_t shown_updates_ = before_.updates;
  double decisions_per_s_ = 0.0;
  double updates_per_s_ = 0.0;
};

void Session::TakeReport(const ProcessReport& report) {
  const auto metric = [&](std::string_view name) {
    for (const auto& [key, value] : report.metrics) {
      if (key == name) return value;
    }
    return 0.0;
  };
  const auto count = [&](std::string_view name) {
    return static_cast<std::uint64_t>(metric(name));
  };
  ledger_.OnRefusals(report.incarnation, count("messages_refused"));
  states_[fmt::format("{} {}", report.role, report.index)] = report.state;
  if (report.role == "actor") {
    ledger_.OnActorReport(report.index, report.incarnation, count("sent"), count("confirmed"),
                          count("decisions"));
  } else if (report.role == "learner") {
    state_.updates = count("updates");
    ledger_.OnWeightsVersion(count("weights_version"));
    policy_lag_versions_ = metric("policy_lag_versions");
  }
}

void Session::Listen() {
  ProcessReport report;
  while (reports_.Take(report)) TakeReport(report);
  ReplayStatus status;
  while (statuses_.Take(status)) {
    ledger_.OnStatus(status);
    status_ = std::move(status);
  }
}

std::string Session::WhoWaits() const {
  std::string text;
  for (const auto& [process, state] : states_) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", process, state);
  }
  return text.empty() ? "no process has reported yet" : text;
}

std::optional<int> Session::CheckProgress(Clock::time_point now) {
  if (now - last_transition_ < kLongestSilence) return std::nullopt;
  line_.Event(fmt::format("no transition was stored for {} s, giving up; {}",
                          std::chrono::seconds(kLongestSilence).count(), WhoWaits()));
  return static_cast<int>(ExitCode::kTransport);
}

std::optional<int> Session::Supervise(Cluster& cluster, Clock::time_point now) {
  std::optional<int> failure;
  for (const Death& death : cluster.Supervise(now)) {
    line_.Event(death.description);
    for (const auto& text : death.log) line_.Event("    | " + text);
    if (death.role == Role::kActor) ledger_.OnActorDeath(death.index, death.incarnation);
    if (death.role == Role::kReplay) ledger_.OnReplayDeath(death.incarnation);
    if (death.run_ends_with) failure = death.run_ends_with;
  }
  return failure;
}

void Session::UpdateState(const Cluster& cluster, Clock::time_point now) {
  const RunTotals totals = ledger_.Totals();
  if (totals.stored > state_.totals.stored) {
    if (!first_transition_) first_transition_ = now;
    last_transition_ = now;
  }
  state_.totals = totals;
  state_.wall_s = before_.wall_s + Seconds(now - began_);
  state_.training_s =
      before_.training_s + (first_transition_ ? Seconds(now - *first_transition_) : 0.0);
  for (const Role role : {Role::kActor, Role::kReplay, Role::kLearner}) {
    const auto former = before_.restarts.find(RoleName(role));
    state_.restarts[RoleName(role)] =
        cluster.restarts(role) + (former == before_.restarts.end() ? 0 : former->second);
  }
  state_.best = evaluator_.best();
}

void Session::Show(Clock::time_point now) {
  const double elapsed_s = Seconds(now - shown_);
  if (elapsed_s >= 1.0) {
    decisions_per_s_ = static_cast<double>(state_.totals.decisions - shown_decisions_) / elapsed_s;
    updates_per_s_ =
        static_cast<double>(state_.updates - std::min(shown_updates_, state_.updates)) / elapsed_s;
    shown_ = now;
    shown_decisions_ = state_.totals.decisions;
    shown_updates_ = state_.updates;
  }
  const RunConfig& run = setup_.run();
  ProgressFigures figures;
  figures.progress = Progress(run, state_.training_s, state_.totals.decisions);
  figures.decisions_per_s = decisions_per_s_;
  figures.updates_per_s = updates_per_s_;
  figures.replay_size = status_.size;
  figures.replay_capacity = status_.capacity;
  figures.policy_lag_versions = policy_lag_versions_;
  figures.agi_s = agi_s_;
  if (const auto yardstick = evaluator_.yardstick())
    figures.best_classical_s = yardstick->agi_s.mean;
  if (figures.progress > 0.0) {
    // The larger share ends the run; it has grown evenly since the folder's beginning.
    figures.left_s = std::max(0.0, state_.training_s * (1.0 / figures.progress - 1.0));
  }
  if (!first_transition_) {
    figures.waiting = "waiting for the first transitions";
  } else if (now - last_transition_ > kQuiet) {
    figures.waiting = WhoWaits();
  }
  line_.Show(figures);
}

void Session::LogMetrics() {
  const auto whole = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  for (const PolicyEvaluation& evaluation : evaluator_.TakeNew()) {
    agi_s_ = evaluation.agi_s;
    metrics_.Append(state_.training_s, {{"kind", "evaluation"},
                                        {"progress", evaluation.progress},
                                        {"updates", whole(evaluation.updates)},
                                        {"agi_s", evaluation.agi_s}});
  }
  metrics_.Append(state_.training_s, {{"kind", "progress"},
                                      {"decisions", whole(state_.totals.decisions)},
                                      {"updates", whole(state_.updates)},
                                      {"decisions_per_s", decisions_per_s_},
                                      {"updates_per_s", updates_per_s_},
                                      {"replay_size", whole(status_.size)},
                                      {"policy_lag_versions", policy_lag_versions_},
                                      {"transitions_stored", whole(state_.totals.stored)}});
}

int Session::Run(std::stop_token stop) {
  Cluster cluster({.program_folder = ProgramFolder(),
                   .run_folder = folder_.path(),
                   .config_file = folder_.config_file(),
                   .domain = domain_.domain(),
                   .run_id = run_id_,
                   .actors = static_cast<std::uint32_t>(setup_.run().actors),
                   .first_incarnation = NewIncarnation()},
                  [this] { return ledger_.Totals().weights_version; });
  line_.Event(
      fmt::format("run {} (DDS domain {}): replay, learner and {} actor{} started; logs in {}",
                  folder_.path().string(), domain_.domain(), setup_.run().actors,
                  setup_.run().actors == 1 ? "" : "s", folder_.logs().string()));
  Every control_due(milliseconds(100));
  Every show_due(milliseconds(500));
  Every log_due(milliseconds(1000));
  Every save_due(milliseconds(2000));
  std::optional<int> failure;
  while (!stop.stop_requested() && !failure) {
    reports_.Wait(milliseconds(20));
    Listen();
    const auto now = Clock::now();
    failure = Supervise(cluster, now);
    if (!failure) failure = CheckProgress(now);
    UpdateState(cluster, now);
    const double progress = Progress(setup_.run(), state_.training_s, state_.totals.decisions);
    if (progress >= 1.0) break;
    evaluator_.set_progress(progress);
    if (control_due.Due(now)) control_.Publish({.progress = progress});
    if (log_due.Due(now)) LogMetrics();
    if (show_due.Due(now)) Show(now);
    if (save_due.Due(now)) WriteRunState(folder_.path(), state_);
  }
  return End(cluster, stop, failure);
}

int Session::End(Cluster& cluster, std::stop_token stop, std::optional<int> failure) {
  const bool hurry = stop.stop_requested() || failure.has_value();
  for (const auto& name : cluster.Stop(kStopGrace, [this] { Listen(); })) {
    line_.Event(name + " did not stop in time and was killed");
  }
  reports_.Wait(milliseconds(20));
  Listen();
  UpdateState(cluster, Clock::now());
  evaluator_.Finish(hurry);
  state_.best = evaluator_.best();
  LogMetrics();
  line_.End();
  WriteRunState(folder_.path(), state_);
  Summarise(std::move(stop), hurry);
  return failure.value_or(0);
}

void Session::Summarise(std::stop_token stop, bool hurry) {
  RunSummary summary{.state = state_, .agi_s = {}, .yardstick = evaluator_.yardstick()};
  if (const auto file = PolicyOfRun(folder_.path())) {
    // In a hurry the judging gets half a second, and is given up after it.
    std::stop_source late;
    std::jthread clock([&](std::stop_token done) {
      const auto deadline = Clock::now() + milliseconds(hurry ? 500 : 600'000);
      const auto give_up = [&] {
        return Clock::now() > deadline || (!hurry && stop.stop_requested());
      };
      while (!done.stop_requested() && !give_up()) {
        std::this_thread::sleep_for(milliseconds(10));
      }
      late.request_stop();
    });
    summary.agi_s =
        ReportedAgi(ReadPolicyFile(*file), evaluator_config_, setup_.context(), late.get_token());
  }
  WriteWholeFile(folder_.summary_file(), SummaryAsJson(summary, setup_.run()));
  fmt::print("{}", FormatSummary(summary, setup_.run(), folder_.path().string()));
}

}  // namespace

double Progress(const RunConfig& run, double training_s, std::uint64_t decisions) {
  const double by_time = run.budget_s > 0.0 ? training_s / run.budget_s : 0.0;
  const double by_decisions =
      run.budget_decisions > 0
          ? static_cast<double>(decisions) / static_cast<double>(run.budget_decisions)
          : 0.0;
  return std::max(by_time, by_decisions);
}

int RunTraining(const TrainSetup& setup, const RunFolder& folder, std::stop_token stop) {
  Session session(setup, folder);
  return session.Run(std::move(stop));
}

}  // namespace ronda
