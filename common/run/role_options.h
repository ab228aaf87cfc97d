#pragma once
// The command line that ronda-actor, ronda-replay and ronda-learner share.
#include <cstdint>
#include <filesystem>
#include <string>

namespace ronda {

struct RoleOptions {
  std::filesystem::path config_file;
  std::filesystem::path run_folder;  // where checkpoints/ is
  int domain = 0;
  std::string run_id;                 // guards against strangers in the same domain
  std::uint32_t index = 0;            // which of the actors
  std::uint64_t incarnation = 0;      // larger for every start of a process
  std::uint64_t weights_version = 0;  // the last one that anybody saw (learner)
  bool end_with_parent = false;
};

/// Prints help or version and exits where asked to; UsageError otherwise where a rule is broken.
RoleOptions ParseRoleOptions(const std::string& role, const std::string& purpose, int argc,
                             char** argv);

}  // namespace ronda
