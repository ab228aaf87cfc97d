#pragma once
// What `--policy` names: a policy file; a run folder (its best policy; `DIR@latest` its latest); or
// the name of a policy that ships.
#include <filesystem>
#include <optional>
#include <string>

namespace ronda {

/// InputError where there is none.
std::filesystem::path FindPolicyFile(const std::string& policy);

/// A run's best policy, its latest where there is no best yet; nullopt where it has none.
std::optional<std::filesystem::path> PolicyOfRun(const std::filesystem::path& run_folder);

}  // namespace ronda
