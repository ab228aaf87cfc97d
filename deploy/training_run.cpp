#include "deploy/training_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>

#include "common/base/error.h"
#include "common/base/whole_file.h"
#include "common/dds/control_writer.h"
#include "common/dds/participant.h"
#include "common/dds/report_reader.h"
#include "common/dds/report_writer.h"
#include "common/dds/status_reader.h"
#include "common/dds/weights_reader.h"
#include "common/policies/network_config.h"
#include "common/run/every.h"
#include "common/run/incarnation.h"
#include "common/run/metrics_log.h"
#include "common/run/paths.h"
#include "common/run/run_domain.h"
#include "common/run/unix_time.h"
#include "deploy/cluster.h"
#include "deploy/find_policy.h"
#include "deploy/kept_files.h"
#include "deploy/learning_curve.h"
#include "deploy/rate_meter.h"
#include "deploy/run_display.h"
#include "deploy/run_status.h"
#include "deploy/status_board.h"
#include "deploy/summary.h"
#include "deploy/training_evaluator.h"
#include "deploy/transition_ledger.h"
#include "deploy/wanted_actors.h"

namespace ronda {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::chrono::seconds kQuiet{5};             // without any transition: said as a problem
constexpr std::chrono::seconds kLongestSilence{120};  // without any transition: the run ends
constexpr milliseconds kStopGrace{1300};              // twice, and some judging: all within 3 s
constexpr std::size_t kEvents = 50;
constexpr std::uint64_t kEvaluationSeed = 1'000'003;  // far from the seeds that are reported

double Seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

TrainingEvaluatorConfig EvaluatorConfig(const TrainSetup& setup, const RunFolder& folder) {
  TrainingEvaluatorConfig config;
  config.agents = setup.run().agents;
  config.conditions = setup.actor().environment.conditions;
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
  Session(const TrainSetup& setup, const RunFolder& folder, RunDisplay::Look look)
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
        metrics_(folder.metrics_file(), "ronda"),
        display_(look, RunDisplay::Events::kAbove),
        curve_(ReadLearningCurve(folder.metrics_file())),
        actors_(setup.run().actors) {
    for (const Role role : {Role::kActor, Role::kReplay, Role::kLearner}) {
      state_.restarts.try_emplace(RoleName(role), 0);
    }
    if (state_.begun_unix_s == 0.0) state_.begun_unix_s = UnixNow();
    WriteWantedActors(folder.path(), actors_);
  }

  int Run(std::stop_token stop);

 private:
  void Listen();
  void TakeReport(const ProcessReport& report);
  void Event(const std::string& text);
  void Keep(const std::string& name, const std::function<void()>& write);
  void CountDeath(const Ending& ending);
  void FollowWantedActors(Cluster& cluster);
  std::optional<int> Supervise(Cluster& cluster, Clock::time_point now);
  /// The exit status of a run in which nothing moves any more.
  std::optional<int> CheckProgress(const Cluster& cluster, Clock::time_point now);
  void UpdateState(const Cluster& cluster, Clock::time_point now);
  double progress() const {
    return Progress(setup_.run(), state_.training_s, state_.totals.decisions);
  }
  void TellEvaluator();
  RunStatus Picture(const Cluster& cluster, Clock::time_point now) const;
  void TakeEvaluations();
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
  RunDisplay display_;
  StatusBoard board_;
  std::deque<RunEvent> events_;  // the last kEvents
  std::vector<CurvePoint> curve_;
  int actors_;                  // wanted
  std::string refused_actors_;  // what the file says that is no such number
  KeptFiles files_;
  std::string why_;  // the run failed

  Clock::time_point began_ = Clock::now();
  std::optional<Clock::time_point> first_transition_;
  ReplayStatus status_;
  Clock::time_point last_transition_ = Clock::now();
  RateMeter decisions_{before_.totals.decisions, Clock::now()};
  RateMeter updates_{before_.updates, Clock::now()};
  double policy_lag_versions_ = 0.0;
};

void Session::Event(const std::string& text) {
  events_.push_back({.unix_s = UnixNow(), .text = text});
  if (events_.size() > kEvents) events_.pop_front();
  display_.Event(text);
}

void Session::Keep(const std::string& name, const std::function<void()>& write) {
  if (const std::string news = files_.Write(name, write); !news.empty()) Event(news);
}

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
  board_.OnReport(report, Clock::now());
  ledger_.OnRefusals(report.incarnation, count("messages_refused"));
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

void Session::FollowWantedActors(Cluster& cluster) {
  int wanted = actors_;
  try {
    wanted = ReadWantedActors(folder_.path());
    refused_actors_.clear();
  } catch (const InputError& error) {
    if (refused_actors_ != error.what()) Event(error.what());
    refused_actors_ = error.what();
  }
  if (wanted == actors_) return;
  Event(fmt::format("{} → {} actors", actors_, wanted));
  actors_ = wanted;
  cluster.set_actors(static_cast<std::uint32_t>(wanted));
}

std::optional<int> Session::CheckProgress(const Cluster& cluster, Clock::time_point now) {
  if (now - last_transition_ < kLongestSilence) return std::nullopt;
  why_ = fmt::format("no transition was stored for {} s, giving up; {}",
                     std::chrono::seconds(kLongestSilence).count(),
                     board_.WhoWaits(cluster.Children()));
  Event(why_);
  return static_cast<int>(ExitCode::kTransport);
}

void Session::CountDeath(const Ending& ending) {
  if (ending.role == Role::kActor) ledger_.OnActorDeath(ending.index, ending.incarnation);
  if (ending.role == Role::kReplay) ledger_.OnReplayDeath(ending.incarnation);
}

std::optional<int> Session::Supervise(Cluster& cluster, Clock::time_point now) {
  std::optional<int> failure;
  for (const Ending& ending : cluster.Supervise(now)) {
    Event(ending.description);
    for (const auto& text : ending.log) display_.Event("    | " + text);
    CountDeath(ending);
    if (!ending.run_ends_with) continue;
    failure = ending.run_ends_with;
    why_ = ending.description;
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

void Session::TellEvaluator() {
  evaluator_.set_progress(
      {.share = progress(), .decisions = state_.totals.decisions, .training_s = state_.training_s});
}

RunStatus Session::Picture(const Cluster& cluster, Clock::time_point now) const {
  const RunConfig& run = setup_.run();
  RunStatus picture;
  picture.map = run.map;
  picture.agents = run.agents;
  picture.algorithm = run.algorithm;
  picture.state = first_transition_ ? "running" : "starting";
  picture.launcher_pid = getpid();
  picture.domain = domain_.domain();
  picture.run_id = run_id_;
  picture.begun_unix_s = state_.begun_unix_s;
  picture.written_unix_s = UnixNow();
  picture.progress = std::min(1.0, progress());
  picture.training_s = state_.training_s;
  // The larger share ends the run; it has grown evenly since the folder's beginning.
  if (progress() > 0.0) {
    picture.left_s = std::max(0.0, state_.training_s * (1.0 / progress() - 1.0));
  }
  picture.updates = state_.updates;
  picture.decisions_per_s = decisions_.per_s();
  picture.updates_per_s = updates_.per_s();
  picture.replay_size = status_.size;
  picture.replay_capacity = status_.capacity;
  picture.totals = state_.totals;
  picture.actors_wanted = actors_;
  picture.curve = curve_;
  if (state_.best) picture.best_agi_s = state_.best->agi_s;
  if (const auto yardstick = evaluator_.yardstick()) {
    picture.best_classical = yardstick->strategy;
    picture.best_classical_agi_s = yardstick->agi_s.mean;
    if (yardstick->bounds) picture.lower_bound_agi_s = yardstick->bounds->agi_s;
  }
  board_.Fill(cluster.Children(), now, picture);
  if (now - last_transition_ > kQuiet) {
    picture.problems.push_back(fmt::format("no transition was stored for {:.0f} s; {}",
                                           Seconds(now - last_transition_),
                                           board_.WhoWaits(cluster.Children())));
  }
  for (const auto& [what, why] : files_.unwritten()) {
    picture.problems.push_back(fmt::format("{} is not kept: {}", what, why));
  }
  picture.events.assign(events_.begin(), events_.end());
  return picture;
}

void Session::TakeEvaluations() {
  for (const PolicyEvaluation& evaluation : evaluator_.TakeNew()) {
    curve_.push_back({.training_s = state_.training_s, .agi_s = evaluation.agi_s});
    Keep("metrics.jsonl", [&] {
      metrics_.Append(state_.training_s,
                      {{"kind", "evaluation"},
                       {"progress", evaluation.progress},
                       {"updates", static_cast<std::int64_t>(evaluation.updates)},
                       {"agi_s", evaluation.agi_s}});
    });
  }
}

void Session::LogMetrics() {
  const auto whole = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  Keep("metrics.jsonl", [&] {
    metrics_.Append(state_.training_s, {{"kind", "progress"},
                                        {"actors", std::int64_t{actors_}},
                                        {"decisions", whole(state_.totals.decisions)},
                                        {"updates", whole(state_.updates)},
                                        {"decisions_per_s", decisions_.per_s()},
                                        {"updates_per_s", updates_.per_s()},
                                        {"replay_size", whole(status_.size)},
                                        {"policy_lag_versions", policy_lag_versions_},
                                        {"transitions_stored", whole(state_.totals.stored)}});
  });
}

int Session::Run(std::stop_token stop) {
  Cluster cluster({.program_folder = ProgramFolder(),
                   .run_folder = folder_.path(),
                   .config_file = folder_.config_file(),
                   .domain = domain_.domain(),
                   .run_id = run_id_,
                   .actors = static_cast<std::uint32_t>(actors_),
                   .first_incarnation = NewIncarnation()},
                  [this] { return ledger_.Totals().weights_version; });
  Event(fmt::format("run {} (DDS domain {}): replay, learner and {} actor{} started; logs in {}",
                    folder_.path().string(), domain_.domain(), actors_, actors_ == 1 ? "" : "s",
                    folder_.logs().string()));
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
    if (!failure) failure = CheckProgress(cluster, now);
    UpdateState(cluster, now);
    if (progress() >= 1.0) break;
    TellEvaluator();
    if (control_due.Due(now)) {
      FollowWantedActors(cluster);
      control_.Publish({.progress = progress(), .actors = static_cast<std::uint32_t>(actors_)});
    }
    decisions_.Count(state_.totals.decisions, now);
    updates_.Count(state_.updates, now);
    TakeEvaluations();
    if (log_due.Due(now)) LogMetrics();
    if (show_due.Due(now)) {
      ProcessReport own;
      own.role = "launcher";
      dds::AddTraffic(participant_, own);
      board_.OnReport(own, now);
      const RunStatus picture = Picture(cluster, now);
      display_.Show(picture);
      Keep("status.json", [&] { WriteRunStatus(folder_.path(), picture); });
    }
    if (save_due.Due(now)) Keep("state.json", [&] { WriteRunState(folder_.path(), state_); });
  }
  return End(cluster, stop, failure);
}

int Session::End(Cluster& cluster, std::stop_token stop, std::optional<int> failure) {
  const bool hurry = stop.stop_requested() || failure.has_value();
  RunStatus last = Picture(cluster, Clock::now());
  last.state = "stopping";
  Keep("status.json", [&] { WriteRunStatus(folder_.path(), last); });
  for (const Ending& ending : cluster.Stop(kStopGrace, [this] { Listen(); })) {
    Event(ending.description);
    CountDeath(ending);
    if (failure || !ending.run_ends_with) continue;
    failure = ending.run_ends_with;
    why_ = ending.description;
  }
  reports_.Wait(milliseconds(20));
  Listen();
  UpdateState(cluster, Clock::now());
  TellEvaluator();
  evaluator_.Finish(hurry);
  state_.best = evaluator_.best();
  TakeEvaluations();
  LogMetrics();
  display_.End();
  Keep("state.json", [&] { WriteRunState(folder_.path(), state_); });
  Summarise(std::move(stop), hurry);
  if (!failure && !files_.unwritten().empty()) {
    failure = static_cast<int>(ExitCode::kCheckpoint);
    why_ = files_.unwritten().begin()->second;
  }

  last = Picture(cluster, Clock::now());
  last.state = failure ? "failed" : progress() >= 1.0 ? "finished" : "stopped";
  last.exit_status = failure.value_or(0);
  last.processes.clear();
  last.problems.clear();
  if (failure) last.problems.push_back(why_);
  Keep("status.json", [&] { WriteRunStatus(folder_.path(), last); });
  return failure.value_or(0);
}

void Session::Summarise(std::stop_token stop, bool hurry) {
  RunSummary summary{.state = state_, .agi_s = {}, .yardstick = evaluator_.yardstick()};
  const auto file = PolicyOfRun(folder_.path());
  PolicyFile policy;
  if (file) {
    policy = ReadPolicyFile(*file);
    // In a hurry it is given up after half a second, and a stop that has come already does not end
    // it before.
    summary.agi_s = ReportedAgi(policy, evaluator_config_, setup_.context(),
                                hurry ? std::stop_token() : std::move(stop),
                                milliseconds(hurry ? 500 : 600'000));
  }
  Keep("summary.json",
       [&] { WriteWholeFile(folder_.summary_file(), SummaryAsJson(summary, setup_.run())); });
  if (summary.agi_s) {
    policy.training.agi_s = summary.agi_s->mean;
    policy.training.agi_ci95_s = summary.agi_s->ci95.value_or(0.0);
    Keep(file->filename().string(), [&] { WritePolicyFile(*file, policy); });
  }
  fmt::print("{}", FormatSummary(summary, setup_.run(), folder_.path().string()));
}

}  // namespace

int RunTraining(const TrainSetup& setup, const RunFolder& folder, RunDisplay::Look look,
                std::stop_token stop) {
  Session session(setup, folder, look);
  return session.Run(std::move(stop));
}

}  // namespace ronda
