#include "deploy/status_board.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace ronda {
namespace {

using std::chrono::duration;
using std::chrono::seconds;

constexpr seconds kRateWindow{2};
constexpr double kStartingS = 20.0;  // until its first report

struct ChannelRole {
  const char* topic;
  const char* from;
  const char* to;
};
// docs/protocol.md
constexpr std::array<ChannelRole, 8> kChannels{{{"experience", "actors", "replay"},
                                                {"credit", "replay", "actors"},
                                                {"sample_request", "learner", "replay"},
                                                {"sample", "replay", "learner"},
                                                {"priorities", "learner", "replay"},
                                                {"weights", "learner", "actors"},
                                                {"report", "all", "launcher"},
                                                {"control", "launcher", "all"}}};

/// What a role counts that makes a rate: {name of the rate, metric}.
std::vector<std::pair<std::string, std::string>> RatesOf(Role role) {
  if (role == Role::kActor) return {{"decisions", "decisions"}, {"transitions", "confirmed"}};
  if (role == Role::kReplay) return {{"stored", "stored"}, {"sampled", "sampled"}};
  return {{"updates", "updates"}};
}

double Metric(const std::map<std::string, double>& metrics, const std::string& name) {
  const auto found = metrics.find(name);
  return found == metrics.end() ? 0.0 : found->second;
}

std::string Name(const ChildFacts& child) { return ProcessName(RoleName(child.role), child.index); }

double Seconds(StatusBoard::TimePoint::duration time) { return duration<double>(time).count(); }

/// "the learner waits for mini-batches", "3 actors wait for credit from the replay".
std::string Waiting(const RunStatus& status, const std::string& role) {
  constexpr std::string_view kPrefix = "waiting for ";
  std::map<std::string, int> waiting;  // what for → how many
  for (const ProcessStatus& process : status.processes) {
    if (process.role == role && process.state.starts_with(kPrefix)) {
      ++waiting[process.state.substr(kPrefix.size())];
    }
  }
  std::string text;
  for (const auto& [what, count] : waiting) {
    const std::string who = count == 1 ? (role == "actor" ? "1 actor" : "the " + role)
                                       : fmt::format("{} {}s", count, role);
    text += fmt::format("{}{} {} for {}", text.empty() ? "" : "; ", who,
                        count == 1 ? "waits" : "wait", what);
  }
  return text;
}

}  // namespace

void StatusBoard::OnReport(const ProcessReport& report, TimePoint now) {
  Process& process = processes_[report.incarnation];
  process.state = report.state;
  process.heard.push_back({now, {report.metrics.begin(), report.metrics.end()}});
  while (process.heard.size() > 2 && now - process.heard[1].at >= kRateWindow) {
    process.heard.pop_front();
  }
}

const StatusBoard::Process* StatusBoard::Find(std::uint64_t incarnation) const {
  const auto found = processes_.find(incarnation);
  return found == processes_.end() ? nullptr : &found->second;
}

double StatusBoard::RatePerS(const Process& process, const std::string& metric,
                             TimePoint now) const {
  const Heard& first = process.heard.front();
  const Heard& last = process.heard.back();
  const double elapsed_s = Seconds(last.at - first.at);
  if (elapsed_s <= 0.0 || now - last.at > kRateWindow) return 0.0;
  return std::max(0.0, Metric(last.metrics, metric) - Metric(first.metrics, metric)) / elapsed_s;
}

ProcessStatus StatusBoard::Describe(const ChildFacts& child, std::uint64_t newest_version,
                                    TimePoint now) const {
  ProcessStatus status;
  status.role = RoleName(child.role);
  status.index = child.index;
  status.pid = child.pid;
  status.restarts = child.restarts;
  status.last_error = child.last_error;
  status.silent_s = Seconds(now - child.started);
  const Process* process = Find(child.incarnation);
  if (child.pid == 0) {
    status.state = child.start_again ? fmt::format("dead, starting again in {:.1f} s",
                                                   std::max(0.0, Seconds(*child.start_again - now)))
                                     : "dead";
  } else {
    status.state = process == nullptr ? "starting" : process->state;
  }
  if (child.leaving) status.state = "leaving";
  if (process == nullptr || child.pid == 0) return status;

  const Heard& last = process->heard.back();
  status.silent_s = Seconds(now - last.at);
  for (const auto& [rate, metric] : RatesOf(child.role)) {
    status.rates_per_s[rate] = RatePerS(*process, metric, now);
  }
  status.weights_version = static_cast<std::uint64_t>(Metric(last.metrics, "weights_version"));
  if (child.role == Role::kLearner) {
    status.lag_versions = Metric(last.metrics, "policy_lag_versions");
  } else if (child.role == Role::kActor && status.weights_version > 0) {
    status.lag_versions =
        static_cast<double>(newest_version - std::min(newest_version, status.weights_version));
  }
  return status;
}

std::vector<std::string> StatusBoard::ProblemsOf(const ChildFacts& child,
                                                 const ProcessStatus& process) const {
  if (child.leaving) return {};
  if (child.pid == 0) {
    return {
        fmt::format("{} is {}: it ended with {}", Name(child), process.state, child.last_error)};
  }
  std::vector<std::string> problems;
  const Process* heard = Find(child.incarnation);
  if (process.silent_s > (heard == nullptr ? kStartingS : kSilentAfterS)) {
    problems.push_back(fmt::format("{} (process {}) has not reported for {:.0f} s", Name(child),
                                   child.pid, process.silent_s));
  }
  if (heard != nullptr && Metric(heard->heard.back().metrics, "checkpoint_fails") > 0.0) {
    problems.push_back(
        fmt::format("{} cannot write its checkpoint (its log says why)", Name(child)));
  }
  return problems;
}

void StatusBoard::Fill(const std::vector<ChildFacts>& children, TimePoint now,
                       RunStatus& status) const {
  for (const ChildFacts& child : children) {
    const ProcessStatus process = Describe(child, status.totals.weights_version, now);
    for (const std::string& problem : ProblemsOf(child, process)) {
      status.problems.push_back(problem);
    }
    status.processes.push_back(process);
  }
  std::ranges::stable_sort(status.processes, {}, [](const ProcessStatus& process) {
    return process.role == "actor" ? process.index + 1 : 0;
  });
  FillChannels(now, status);
}

void StatusBoard::FillChannels(TimePoint now, RunStatus& status) const {
  for (const ChannelRole& role : kChannels) {
    const std::string messages = kMessagesMetric + fmt::format("ronda/{}", role.topic);
    const std::string bytes = kBytesMetric + fmt::format("ronda/{}", role.topic);
    ChannelStatus channel;
    channel.topic = role.topic;
    channel.from = role.from;
    channel.to = role.to;
    for (const auto& [incarnation, process] : processes_) {
      const auto& newest = process.heard.back().metrics;
      channel.messages += static_cast<std::uint64_t>(Metric(newest, messages));
      channel.bytes += static_cast<std::uint64_t>(Metric(newest, bytes));
      channel.messages_per_s += RatePerS(process, messages, now);
      channel.bytes_per_s += RatePerS(process, bytes, now);
    }
    status.channels.push_back(channel);
  }
  const auto channel = [&](std::string_view topic) -> ChannelStatus& {
    return *std::ranges::find(status.channels, topic, &ChannelStatus::topic);
  };
  channel("experience").waiting = Waiting(status, "actor");
  channel("sample").waiting = Waiting(status, "learner");
  channel("sample_request").waiting = Waiting(status, "replay");
}

std::string StatusBoard::WhoWaits(const std::vector<ChildFacts>& children) const {
  std::string text;
  for (const ChildFacts& child : children) {
    const Process* process = Find(child.incarnation);
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", Name(child),
                        process == nullptr ? "has not reported yet" : process->state);
  }
  return text;
}

}  // namespace ronda
