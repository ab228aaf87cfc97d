#include "deploy/config_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "actor/actor_config.h"
#include "common/run/config.h"
#include "common/run/run_config.h"
#include "deploy/train_setup.h"
#include "learner/learner_config.h"
#include "replay/replay_config.h"

namespace ronda {
namespace {

constexpr std::string_view kPreface =
    "# Configuration\n"
    "\n"
    "Every key that the processes of a run know. This page is what `ronda config` prints.\n"
    "\n"
    "- A new run takes keys from `--config FILE` (TOML) and from `--set KEY=VALUE`, which wins.\n"
    "- `ronda train --print-config` prints the file that a run would have, and stops. It is kept\n"
    "  in the run folder as `config.toml`.\n"
    "- A new run has as many actors as the machine has cores, and 90 s, where nothing says\n"
    "  otherwise.\n"
    "- `ronda` reads all keys before it starts anything. A key that nobody knows, or a value that\n"
    "  breaks its rule, ends it with status 3, the place and the rule.\n"
    "- T_ref is the length of a short closed walk through the map, over the sum of speeds\n"
    "  ([glossary](glossary.md)).\n";

struct Keys {
  std::string readers;
  std::vector<Config::Known> known;
};

/// What each process asks for beyond what all of them do.
std::vector<Keys> KeysOfProcesses() {
  RunConfig run;
  run.shape = {.observation_size = 1, .num_actions = 1, .extras_size = 0};  // any network will do
  run.schema = "any";
  const auto of = [&](std::string readers, const auto& read) {
    Config config;
    read(config);
    return Keys{std::move(readers), config.known()};
  };
  return {of("all", [](Config& config) { ReadRunConfig(config); }),
          of("actor", [&](Config& config) { ReadActorConfig(config, run); }),
          of("replay", [&](Config& config) { ReadReplayConfig(config, run); }),
          of("learner", [&](Config& config) { ReadLearnerConfig(config, run); }),
          of("ronda", [](Config& config) { ReadEvaluationSchedule(config); })};
}

std::string Cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

}  // namespace

std::string ConfigurationPage() {
  std::vector<std::string> sections;  // in the order in which they are met
  std::map<std::string, std::string> rows;
  for (const Keys& keys : KeysOfProcesses()) {
    for (const Config::Known& known : keys.known) {
      const auto dot = known.key.rfind('.');
      const std::string section =
          dot == std::string::npos ? "Without a section" : "[" + known.key.substr(0, dot) + "]";
      const std::string rule =
          known.listed_in.empty() ? known.rule : "a name of " + known.listed_in;
      if (!rows.contains(section)) sections.push_back(section);
      rows[section] +=
          fmt::format("| `{}` | `{}` | {} | {} | {} |\n", known.key, Cell(known.default_value),
                      Cell(rule), keys.readers, Cell(known.doc));
    }
  }
  std::string page(kPreface);
  for (const std::string& section : sections) {
    page += fmt::format(
        "\n## {}\n\n| key | default | rule | read by | meaning |\n|---|---|---|---|---|\n{}",
        section, rows[section]);
  }
  return page;
}

void AddConfigCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("config", "print every key of the configuration, with its meaning");
  command->footer("What a run would have: ronda train --print-config");
  command->callback([] { fmt::print("{}", ConfigurationPage()); });
}

}  // namespace ronda
