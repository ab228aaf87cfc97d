#include "deploy/cluster.h"

#include <fmt/format.h>

#include <csignal>
#include <thread>

#include "common/base/error.h"

namespace ronda {
namespace {

constexpr std::size_t kLogLines = 5;

/// Whether the same would come again however often the process is started.
bool IsFinal(const ExitStatus& status) {
  if (status.signal != 0) return false;
  const auto code = static_cast<ExitCode>(status.code);
  return code == ExitCode::kUsage || code == ExitCode::kInput || code == ExitCode::kCheckpoint ||
         code == ExitCode::kDivergence;
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

std::string Cluster::Member::Name() const {
  return role == Role::kActor ? fmt::format("actor {}", index) : RoleName(role);
}

Cluster::Cluster(const ClusterOptions& options, std::function<std::uint64_t()> weights_version)
    : options_(options),
      weights_version_(std::move(weights_version)),
      next_incarnation_(options.first_incarnation) {
  const auto now = std::chrono::steady_clock::now();
  const auto add = [&](Role role, std::uint32_t index) {
    Member& member = members_.emplace_back();
    member.role = role;
    member.index = index;
  };
  add(Role::kReplay, 0);
  add(Role::kLearner, 0);
  for (std::uint32_t i = 0; i < options.actors; ++i) add(Role::kActor, i);
  for (Member& member : members_) Start(member, now);
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
  ++member.starts;
}

Death Cluster::Bury(Member& member, const ExitStatus& status, TimePoint now) {
  Death death{.role = member.role,
              .index = member.index,
              .incarnation = member.incarnation,
              .description = {},
              .log = member.child->LastLogLines(kLogLines),
              .run_ends_with = {}};
  const RestartLimits limits;
  const std::string how = fmt::format("{} (process {}) ended with {}", member.Name(),
                                      member.child->pid(), status.Description());
  member.child.reset();
  member.start_again = member.policy.Died(member.started, now);
  if (IsFinal(status)) {
    death.run_ends_with = status.code;
    death.description = how + "; starting it again would not help";
  } else if (!member.start_again) {
    death.run_ends_with = static_cast<int>(ExitCode::kChildGaveUp);
    death.description =
        fmt::format("{}; {} deaths without {} healthy seconds between them, giving up", how,
                    limits.most_deaths, limits.healthy.count() / 1000);
  } else {
    const std::chrono::duration<double> wait = *member.start_again - now;
    death.description = fmt::format("{}; starting it again in {:.1f} s", how, wait.count());
  }
  return death;
}

std::vector<Death> Cluster::Supervise(TimePoint now) {
  std::vector<Death> deaths;
  for (Member& member : members_) {
    if (member.child) {
      if (const auto status = member.child->Poll()) deaths.push_back(Bury(member, *status, now));
    } else if (member.start_again && now >= *member.start_again) {
      Start(member, now);
    }
  }
  return deaths;
}

void Cluster::StopRoles(const std::function<bool(Role)>& chosen, std::chrono::milliseconds grace,
                        const std::function<void()>& while_waiting,
                        std::vector<std::string>& killed) {
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
    if (!running(member)) continue;
    killed.push_back(member.Name());
    member.child->Signal(SIGKILL);
    member.child->WaitFor(std::chrono::seconds(1));
  }
}

std::vector<std::string> Cluster::Stop(std::chrono::milliseconds grace,
                                       const std::function<void()>& while_waiting) {
  std::vector<std::string> killed;
  StopRoles([](Role role) { return role != Role::kReplay; }, grace, while_waiting, killed);
  StopRoles([](Role role) { return role == Role::kReplay; }, grace, while_waiting, killed);
  return killed;
}

int Cluster::restarts(Role role) const {
  int restarts = 0;
  for (const Member& member : members_) {
    if (member.role == role) restarts += member.starts - 1;
  }
  return restarts;
}

}  // namespace ronda
