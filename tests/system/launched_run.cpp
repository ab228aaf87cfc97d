#include "tests/system/launched_run.h"

#include <fmt/format.h>
#include <poll.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <iterator>

namespace ronda {
namespace {

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

nlohmann::json ReadJson(const std::filesystem::path& path) {
  const auto json = nlohmann::json::parse(ReadText(path), nullptr, false);
  return json.is_discarded() ? nlohmann::json() : json;
}

std::vector<std::string> Resolve(std::vector<std::string> arguments,
                                 const std::filesystem::path& run_folder) {
  for (auto& argument : arguments) {
    if (argument == "{run}") argument = run_folder.string();
  }
  return arguments;
}

}  // namespace

bool WaitUntil(const std::function<bool()>& condition, std::chrono::seconds at_most) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    ::poll(nullptr, 0, 20);  // looks 50 times a second, and leaves the cores to the cluster
  }
  return true;
}

std::vector<pid_t> ChildrenNamed(pid_t parent, const std::string& name) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string text = entry.path().filename().string();
    if (text.find_first_not_of("0123456789") != std::string::npos) continue;
    // pid (name) state ppid …
    const std::string stat = ReadText(entry.path() / "stat");
    const auto open = stat.find('(');
    const auto close = stat.rfind(')');
    if (open == std::string::npos || close == std::string::npos) continue;
    if (stat.substr(open + 1, close - open - 1) != name.substr(0, 15)) continue;
    if (stat.size() < close + 5 || stat[close + 2] == 'Z') continue;
    if (std::stol(stat.substr(close + 4)) == parent) children.push_back(std::stoi(text));
  }
  return children;
}

bool IsAlive(pid_t pid) {
  const std::string stat = ReadText(fmt::format("/proc/{}/stat", pid));
  const auto close = stat.rfind(')');
  return close != std::string::npos && stat.size() > close + 2 && stat[close + 2] != 'Z';
}

LaunchedRun::LaunchedRun(const std::filesystem::path& run_folder,
                         std::vector<std::string> arguments, const std::filesystem::path& program)
    : run_folder_(run_folder),
      output_(run_folder.string() + ".output"),
      child_(program, Resolve(std::move(arguments), run_folder), output_) {}

ExitStatus LaunchedRun::WaitForEnd(std::chrono::seconds at_most) {
  const auto status = child_.WaitFor(at_most);
  INFO(Output());
  REQUIRE(status.has_value());
  return *status;
}

std::string LaunchedRun::Output() const { return ReadText(output_); }

nlohmann::json LaunchedRun::Status() const { return ReadJson(run_folder_ / "status.json"); }

nlohmann::json LaunchedRun::Summary() const { return ReadJson(run_folder_ / "summary.json"); }

nlohmann::json LaunchedRun::State() const { return ReadJson(run_folder_ / "state.json"); }

std::uint64_t LaunchedRun::StoredTransitions() const {
  const auto status = Status();
  return status.is_null() ? 0 : status["totals"]["stored"].get<std::uint64_t>();
}

std::uint64_t LaunchedRun::WeightsVersion() const {
  const auto status = Status();
  return status.is_null() ? 0 : status["totals"]["weights_version"].get<std::uint64_t>();
}

std::vector<std::string> TrainFourNodes(const std::string& decisions) {
  return {"train",
          "--map",
          "4nodes",
          "--agents",
          "2",
          "--actors",
          "2",
          "--run",
          "{run}",
          "--set",
          "replay.min_size=1000",
          "--decisions",
          decisions};
}

bool GoesOn(const LaunchedRun& run) {
  const std::uint64_t stored = run.StoredTransitions();
  const auto version = run.WeightsVersion();
  return WaitUntil(
      [&] { return run.StoredTransitions() > stored + 2000 && run.WeightsVersion() > version + 5; },
      std::chrono::seconds(60));
}

void CheckCounts(const nlohmann::json& summary) {
  REQUIRE_FALSE(summary.is_null());
  INFO(summary.dump(1));
  CHECK(summary["transitions_sent"].get<std::uint64_t>() ==
        summary["transitions_stored"].get<std::uint64_t>() +
            summary["transitions_lost"].get<std::uint64_t>() +
            summary["transitions_in_flight"].get<std::uint64_t>());
  CHECK(summary["transitions_doubled"] == 0);
  CHECK(summary["transitions_in_flight"] == 0);
  CHECK(summary["messages_refused"] == 0);
}

std::filesystem::path ProgramsWithScript(const std::filesystem::path& folder,
                                         const std::string& replaced, const std::string& script) {
  std::filesystem::create_directory(folder);
  for (const std::string name : {"ronda", "ronda-actor", "ronda-replay", "ronda-learner"}) {
    if (name != replaced) {
      std::filesystem::copy_file(std::filesystem::path(RONDA_BIN_DIR) / name, folder / name);
    }
  }
  std::ofstream(folder / replaced) << "#!/bin/sh\n" << script;
  std::filesystem::permissions(folder / replaced, std::filesystem::perms::owner_all);
  return folder / "ronda";
}

}  // namespace ronda
