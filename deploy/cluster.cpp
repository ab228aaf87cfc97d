#include "deploy/cluster.h"

#include <fmt/format.h>

#include <csignal>
#include <set>
#include <thread>

#include "common/base/error.h"
#include "deploy/run_status.h"

namespace ronda {
namespace {

constexpr std::size_t kLogLines = 5;
constexpr int kCannotBeLoaded = 127;             // what the system's loader exits with
constexpr std::chrono::seconds kLeaveGrace{15};  // an actor waits 10 s for its confirmations

/// Whether the same would come again however often the process is started.
bool IsFinal(const ExitStatus& status) {
  if (status.signal != 0) return false;
  const auto code = static_cast<ExitCode>(status.code);
  return code == ExitCode::kUsage || code == ExitCode::kInput || code == ExitCode::kCheckpoint ||
         code == ExitCode::kDivergence;
}

/// What a process does that SIGTERM has asked to stop (run/process.h).
bool StoppedWell(const ExitStatus& status) {
  return status.signal == 0 && (status.code == 0 || status.code == 128 + SIGTERM);
}

std::string LastWords(const std::vector<std::string>& log) {
  return log.empty() ? "it said nothing" : log.back();
}

/// What was the matter with a child that exits is in its last line; a signal leaves no word.
std::string HowItEnded(const ExitStatus& status, const std::vector<std::string>& log) {
  if (status.signal != 0) return status.Description();
  return fmt::format("{} ({})", status.Description(), LastWords(log));
}

}  // namespace

const char* RoleName(Role role) {
  switch (role) {
    case Role::kReplay:
      return "replay";
    case Role::kLearner:
      return "learner";
    case Role::kActor:
      return "actor";
  }
  return "?";
}

std::string Cluster::Member::Name() const { return ProcessName(RoleName(role), index); }

Cluster::Cluster(const ClusterOptions& options, std::function<std::uint64_t()> weights_version)
    : options_(options),
      weights_version_(std::move(weights_version)),
      next_incarnation_(options.first_incarnation) {
  const auto now = std::chrono::steady_clock::now();
  Add(Role::kReplay, 0, now);
  Add(Role::kLearner, 0, now);
  AddWantedActors(now);
}

void Cluster::Add(Role role, std::uint32_t index, TimePoint now) {
  Member& member = members_.emplace_back();
  member.role = role;
  member.index = index;
  Start(member, now);
}

void Cluster::AddWantedActors(TimePoint now) {
  std::set<std::uint32_t> there;
  for (const Member& member : members_) {
    if (member.role == Role::kActor) there.insert(member.index);
  }
  for (std::uint32_t i = 0; i < options_.actors; ++i) {
    if (!there.contains(i)) Add(Role::kActor, i, now);  // one that still leaves comes back later
  }
}

void Cluster::DismissUnwantedActors(TimePoint now) {
  for (Member& member : members_) {
    const bool wanted = member.role != Role::kActor || member.index < options_.actors;
    if (wanted || member.kill_at) continue;
    member.kill_at = now + kLeaveGrace;
    if (member.child) member.child->Signal(SIGTERM);
  }
  members_.remove_if([](const Member& member) { return member.kill_at && !member.child; });
}

std::filesystem::path Cluster::LogFile(const Member& member) const {
  const std::string name = member.role == Role::kActor
                               ? fmt::format("actor-{}.log", member.index)
                               : fmt::format("{}.log", RoleName(member.role));
  return options_.run_folder / "logs" / name;
}

void Cluster::Start(Member& member, TimePoint now) {
  member.incarnation = next_incarnation_++;
  member.started = now;
  member.start_again.reset();
  std::vector<std::string> arguments{"--config",
                                     options_.config_file.string(),
                                     "--run",
                                     options_.run_folder.string(),
                                     "--domain",
                                     std::to_string(options_.domain),
                                     "--run-id",
                                     options_.run_id,
                                     "--index",
                                     std::to_string(member.index),
                                     "--incarnation",
                                     std::to_string(member.incarnation),
                                     "--end-with-parent"};
  if (member.role == Role::kLearner) {
    arguments.insert(arguments.end(), {"--weights-version", std::to_string(weights_version_())});
  }
  member.child.reset();
  member.child.emplace(options_.program_folder / fmt::format("ronda-{}", RoleName(member.role)),
                       arguments, LogFile(member));
  if (member.starts++ > 0) ++restarts_[member.role];
}

Ending Cluster::EndingOf(const Member& member) const {
  return {.role = member.role,
          .index = member.index,
          .incarnation = member.incarnation,
          .description = {},
          .log = member.child->LastLogLines(kLogLines),
          .run_ends_with = {}};
}

Ending Cluster::Farewell(Member& member, const ExitStatus& status) {
  Ending ending = EndingOf(member);
  if (StoppedWell(status)) {
    ending.description = member.Name() + " has left";
    ending.log.clear();
  } else {
    ending.description = fmt::format("{} (process {}) was to leave, and ended with {}",
                                     member.Name(), member.child->pid(), status.Description());
  }
  member.child.reset();
  return ending;
}

Ending Cluster::Bury(Member& member, const ExitStatus& status, TimePoint now) {
  Ending death = EndingOf(member);
  const RestartLimits limits;
  member.last_error = HowItEnded(status, death.log);
  const std::string who = fmt::format("{} (process {})", member.Name(), member.child->pid());
  member.child.reset();
  member.start_again = member.policy.Died(member.started, now);
  if (status.code == kCannotBeLoaded) {
    death.run_ends_with = static_cast<int>(ExitCode::kChildGaveUp);
    death.description = fmt::format(
        "{} cannot be loaded: {}; deploy/setup.sh installs the libraries that Ronda needs", who,
        LastWords(death.log));
  } else if (IsFinal(status)) {
    death.run_ends_with = status.code;
    death.description =
        fmt::format("{} ended with {}; starting it again would not help", who, member.last_error);
  } else if (!member.start_again) {
    death.run_ends_with = static_cast<int>(ExitCode::kChildGaveUp);
    death.description = fmt::format(
        "{} ended with {}; {} deaths without {} healthy seconds between them, giving up", who,
        member.last_error, limits.most_deaths, limits.healthy.count() / 1000);
  } else {
    const std::chrono::duration<double> wait = *member.start_again - now;
    death.description = fmt::format("{} ended with {}; starting it again in {:.1f} s", who,
                                    member.last_error, wait.count());
  }
  return death;
}

std::vector<Ending> Cluster::Supervise(TimePoint now) {
  std::vector<Ending> endings;
  DismissUnwantedActors(now);
  for (Member& member : members_) {
    if (member.child) {
      if (member.kill_at && now >= *member.kill_at) member.child->Signal(SIGKILL);
      const auto status = member.child->Poll();
      if (!status) continue;
      endings.push_back(member.kill_at ? Farewell(member, *status) : Bury(member, *status, now));
    } else if (member.start_again && now >= *member.start_again) {
      Start(member, now);
    }
  }
  AddWantedActors(now);
  return endings;
}

void Cluster::StopRoles(const std::function<bool(Role)>& chosen, std::chrono::milliseconds grace,
                        const std::function<void()>& while_waiting, std::vector<Ending>& unwell) {
  const auto running = [&](Member& member) {
    return chosen(member.role) && member.child && !member.child->Poll();
  };
  for (Member& member : members_) {
    member.start_again.reset();
    if (running(member)) member.child->Signal(SIGTERM);
  }
  const auto deadline = std::chrono::steady_clock::now() + grace;
  const auto any_running = [&] {
    bool any = false;
    for (Member& member : members_) any |= running(member);
    return any;
  };
  while (any_running() && std::chrono::steady_clock::now() < deadline) {
    while_waiting();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  for (Member& member : members_) {
    if (!chosen(member.role) || !member.child) continue;
    const bool late = running(member);
    if (late) {
      member.child->Signal(SIGKILL);
      member.child->WaitFor(std::chrono::seconds(1));
    }
    const ExitStatus status = member.child->Poll().value_or(ExitStatus{});
    if (!late && StoppedWell(status)) continue;
    Ending ending = EndingOf(member);
    if (late) {
      ending.description = member.Name() + " did not stop in time and was killed";
    } else {
      ending.description =
          fmt::format("{} ended with {}", member.Name(), HowItEnded(status, ending.log));
      if (status.signal == 0) ending.run_ends_with = status.code;
    }
    unwell.push_back(ending);
  }
}

std::vector<Ending> Cluster::Stop(std::chrono::milliseconds grace,
                                  const std::function<void()>& while_waiting) {
  std::vector<Ending> unwell;
  StopRoles([](Role role) { return role != Role::kReplay; }, grace, while_waiting, unwell);
  StopRoles([](Role role) { return role == Role::kReplay; }, grace, while_waiting, unwell);
  return unwell;
}

std::vector<ChildFacts> Cluster::Children() const {
  std::vector<ChildFacts> children;
  for (const Member& member : members_) {
    children.push_back({.role = member.role,
                        .index = member.index,
                        .pid = member.child ? member.child->pid() : 0,
                        .incarnation = member.incarnation,
                        .restarts = member.starts - 1,
                        .leaving = member.kill_at.has_value(),
                        .last_error = member.last_error,
                        .started = member.started,
                        .start_again = member.start_again});
  }
  return children;
}

int Cluster::restarts(Role role) const {
  const auto found = restarts_.find(role);
  return found == restarts_.end() ? 0 : found->second;
}

}  // namespace ronda
