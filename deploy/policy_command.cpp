#include "deploy/policy_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "common/evaluation/output_file.h"
#include "common/policies/policy_file.h"
#include "deploy/find_policy.h"
#include "deploy/new_file.h"
#include "deploy/policy_info.h"

namespace ronda {
namespace {

void Info(const std::string& policy_name, const std::string& json_path) {
  const std::filesystem::path path = FindPolicyFile(policy_name);
  const PolicyFile policy = ReadPolicyFile(path);
  if (!json_path.empty()) {
    OutputFile json(json_path);
    json.Write(PolicyAsJson(path, policy));
    json.Commit();
  }
  fmt::print("{}", FormatPolicy(path, policy));
}

void Extract(const std::string& run, const std::filesystem::path& target, bool force) {
  CheckMayWrite(target, force);
  const PolicyFile policy = ReadPolicyFile(FindPolicyFile(run));
  WritePolicyFile(target, policy);
  fmt::print("{}", FormatPolicy(target, ReadPolicyFile(target)));
}

void AddInfo(CLI::App& parent) {
  struct Arguments {
    std::string policy;
    std::string json_path;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = parent.add_subcommand("info", "what a policy file says of itself");
  command
      ->add_option("FILE", arguments->policy,
                   "a policy file, a run folder (RUN@latest) or a shipped policy's name")
      ->required();
  command->add_option("--json", arguments->json_path, "write it to this file");
  command->footer("Example:\n  ronda policy info runs/first");
  command->callback([arguments] { Info(arguments->policy, arguments->json_path); });
}

void AddExtract(CLI::App& parent) {
  struct Arguments {
    std::string run;
    std::string file;
    bool force = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = parent.add_subcommand("extract", "a run's best policy as one file");
  command->add_option("RUN", arguments->run, "a run folder; RUN@latest for its latest policy")
      ->required();
  command->add_option("FILE", arguments->file, "the file to write")->required();
  command->add_flag("--force", arguments->force, "replace a file that is there");
  command->footer("Example:\n  ronda policy extract runs/first cumberland-10.ronda");
  command->callback([arguments] { Extract(arguments->run, arguments->file, arguments->force); });
}

}  // namespace

void AddPolicyCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("policy", "look at policy files, take one out of a run");
  command->require_subcommand(1);
  AddInfo(*command);
  AddExtract(*command);
}

}  // namespace ronda
